// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include "rigidformer_ros/simulated/camera/camera_messages.hpp"
#include "rigidformer_ros/simulated/playback/private_parameters.hpp"
#include "rigidformer_ros/simulated/playback/scene_clock.hpp"

namespace rigidformer_ros::camera {

/// How the frames are played.
struct PlaybackOptions {
  bool wait_for_node = true;   ///< Start only when the prediction node is ready
  bool publish_clock = false;  ///< Publish a simulated time on /clock
  double time_scale = 1.0;     ///< Simulated seconds per second of wall time; another value than 1 needs publish_clock
};

/// Reads the camera options from private parameters. Options without a parameter keep their defaults. Throws
/// std::invalid_argument naming the parameter.
CameraOptions read_camera_options(demo::PrivateParameters& parameters);

/// Reads the playback options in the same way.
PlaybackOptions read_playback_options(demo::PrivateParameters& parameters);

/// Plays scenes as a depth camera with a segmentation sees them. It publishes the topics of camera_messages.hpp, and
/// the pose of the camera on tf.
class DepthCameraPublisher {
 public:
  DepthCameraPublisher(ros::NodeHandle& node, const CameraOptions& options, const PlaybackOptions& playback);

  /// Plays until the last scene or shutdown.
  void run();

 private:
  void play(const CameraScene& scene);
  void publish(const FrameMessages& messages);

  ros::NodeHandle node_;
  CameraOptions options_;
  PlaybackOptions playback_;
  demo::SceneClock clock_;
  tf2_ros::StaticTransformBroadcaster static_frames_;
  tf2_ros::TransformBroadcaster frames_;
  ros::Publisher cloud_;
  ros::Publisher object_clouds_;
  ros::Publisher truth_;
};

}  // namespace rigidformer_ros::camera
