// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>

#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/health/forecast_check.hpp"
#include "rigidformer_ros/outputs/object_publishers.hpp"
#include "rigidformer_ros/outputs/visualization.hpp"

namespace rigidformer_ros {

/// All output topics. Point clouds and paths are made only for subscribers.
class ForecastPublisher {
 public:
  ForecastPublisher(ros::NodeHandle& node, const NodeParameters& parameters);

  void publish(const SceneRollout& rollout);

  /// `stamp` is the t0 of the newest scene compared.
  void publish(const ForecastQuality& quality, rigidformer::Stamp stamp);

  /// Removes the markers of the last forecast and the topics of its objects.
  void clear();

  void set_display(const DisplayParameters& display);

 private:
  void publish_objects(const SceneRollout& rollout);
  void clear_markers();

  std::string fixed_frame_;
  double check_window_s_;
  bool with_markers_;
  ForecastVisualizer visualizer_;
  ros::Publisher forecast_;
  ros::Publisher forecast_cloud_;
  ros::Publisher predicted_poses_;
  ros::Publisher markers_;
  ros::Publisher forecast_error_;
  ObjectPublishers<sensor_msgs::PointCloud2> object_points_;
  ObjectPublishers<nav_msgs::Path> paths_;
};

}  // namespace rigidformer_ros
