// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <rigidformer_ros/ObjectClouds.h>
#include <rigidformer_ros/SceneForecast.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

#include "rigidformer_ros/simulated/camera/camera_scene.hpp"

namespace rigidformer_ros::camera {

/// Names of the topics, relative to the namespace of the program.
inline constexpr char kCloudTopic[] = "cloud";
inline constexpr char kObjectCloudsTopic[] = "object_clouds";
inline constexpr char kTruthTopic[] = "camera/truth";

/// Everything that a perception pipeline would say about one frame.
struct FrameMessages {
  sensor_msgs::PointCloud2 cloud;  ///< Fields x y z [m] and, if asked for, label (0 = background), in the camera frame
  ObjectClouds object_clouds;      ///< The objects that are seen, with their true poses, in the camera frame
  std::vector<geometry_msgs::TransformStamped> object_frames;  ///< True poses of the same objects in the fixed frame
};

/// Renders a frame of the scene and writes its messages.
FrameMessages make_messages(const CameraScene& scene, int frame, const CameraOptions& options, const ros::Time& stamp);

/// The pose of the camera in the fixed frame.
geometry_msgs::TransformStamped camera_transform(const CameraScene& scene, const CameraOptions& options,
                                                 const ros::Time& stamp);

/// The true motion of all objects through the scene, as if it were a forecast with one pose per frame. The poses are
/// those of the body frames, whose origins are the centres of mass. `start` is the time of frame 0.
SceneForecast make_truth(const CameraScene& scene, const CameraOptions& options, const ros::Time& start);

}  // namespace rigidformer_ros::camera
