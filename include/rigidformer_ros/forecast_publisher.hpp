// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <map>
#include <string>

#include "rigidformer_ros/forecaster.hpp"
#include "rigidformer_ros/visualization.hpp"

namespace rigidformer_ros {

/// All output topics. Point clouds are made only for subscribers.
class ForecastPublisher {
 public:
  ForecastPublisher(ros::NodeHandle& node, const NodeParameters& parameters);

  void publish(const SceneRollout& rollout);

  /// Removes the markers of the last forecast.
  void clear();

 private:
  void publish_object_points(const SceneRollout& rollout);

  ros::NodeHandle node_;
  std::string fixed_frame_;
  bool with_markers_;
  ForecastVisualizer visualizer_;
  ros::Publisher forecast_;
  ros::Publisher forecast_cloud_;
  ros::Publisher predicted_poses_;
  ros::Publisher markers_;
  std::map<std::string, ros::Publisher> object_points_;  ///< By object id
};

}  // namespace rigidformer_ros
