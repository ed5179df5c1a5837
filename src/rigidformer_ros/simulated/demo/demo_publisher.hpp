// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <string>
#include <vector>

#include "rigidformer_ros/simulated/demo/demo_scene.hpp"
#include "rigidformer_ros/simulated/playback/scene_clock.hpp"

namespace rigidformer_ros::demo {

/// Private parameters of the publisher. A member's name is the name of its parameter; config/demo.yaml and
/// launch/demo.launch set them.
struct DemoParameters {
  std::string scene_set = "movi_b";     ///< One of rigidformer::scene_set_names()
  int seed = 1;                         ///< Seed of the scenes
  int num_scenes = 0;                   ///< Number of scenes; 0 = until shutdown
  double scene_duration = 3.0;          ///< Simulated motion per scene [s]
  double pause = 1.5;                   ///< Time without any cloud between two scenes [s]
  double cloud_rate = 30.0;             ///< Clouds per object and second [Hz]; must divide 240
  int points_per_object = 256;          ///< Points on the whole surface of each object; 0 = the corners of its mesh
  std::string camera_frame = "camera";  ///< Frame of the clouds
  std::string fixed_frame = "world";    ///< Frame of the world, z up
  bool wait_for_node = true;            ///< Start only when the prediction node is ready
  bool publish_clock = false;           ///< Publish a simulated time on /clock
  double time_scale = 1.0;              ///< Simulated seconds per second of wall time; needs publish_clock
  double hold_at = -1.0;                ///< Time of the first scene at which it stops for good [s]; negative = never

  /// Reads the private parameters. Throws std::invalid_argument naming the parameter that is not usable.
  static DemoParameters read(const ros::NodeHandle& private_node);
};

/// Plays simulated scenes as a perception pipeline would publish them. The points of each object are published in the
/// same order in every frame on `/objects/ID/points`, all objects together with labels on `/cloud`, the pose of the
/// camera on tf, and the true motion on `demo/truth`. Clouds are in the frame of the camera.
class DemoPublisher {
 public:
  DemoPublisher(ros::NodeHandle& node, const DemoParameters& parameters);

  /// Plays until the last scene or shutdown.
  void run();

 private:
  void publish_camera();
  void play(const DemoScene& scene, bool hold);
  void publish_truth(const DemoScene& scene, const ros::Time& start);
  void publish_clouds(const DemoScene& scene, int frame, const ros::Time& stamp);

  ros::NodeHandle node_;
  DemoParameters parameters_;
  SceneClock clock_;
  rigidformer::RigidTransform T_camera_world_;
  tf2_ros::StaticTransformBroadcaster tf_;
  std::vector<ros::Publisher> object_clouds_;
  ros::Publisher labelled_cloud_;
  ros::Publisher truth_;
};

}  // namespace rigidformer_ros::demo
