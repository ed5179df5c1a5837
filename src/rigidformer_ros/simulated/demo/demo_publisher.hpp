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

/// Private parameters of the publisher; see config/demo.yaml and launch/demo.launch.
struct DemoParameters {
  std::string scene_set = "movi_b";
  int seed = 1;
  int num_scenes = 0;           ///< 0 = until shutdown
  double scene_duration = 3.0;  ///< [s]
  double pause = 1.5;           ///< [s]
  double cloud_rate = 30.0;     ///< [Hz]
  int points_per_object = 256;
  std::string camera_frame = "camera";
  std::string fixed_frame = "world";
  bool wait_for_node = true;
  bool publish_clock = false;
  double time_scale = 1.0;
  double hold_at = -1.0;  ///< [s] of the first scene; negative = never

  /// Throws std::invalid_argument naming the parameter.
  static DemoParameters read(const ros::NodeHandle& private_node);
};

/// Plays simulated scenes as a perception pipeline would publish them: /objects/<id>/points (ordered, camera frame),
/// /cloud (all objects, labelled), tf of the camera, and the truth on demo/truth.
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
