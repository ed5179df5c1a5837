// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast_publisher.hpp"

#include "rigidformer_ros/forecast_messages.hpp"
#include "rigidformer_ros/names.hpp"

namespace rigidformer_ros {

ForecastPublisher::ForecastPublisher(ros::NodeHandle& node, const NodeParameters& parameters)
    : node_(node),
      fixed_frame_(parameters.fixed_frame),
      with_markers_(parameters.display.markers),
      visualizer_(parameters.display, parameters.fixed_frame),
      forecast_(node_.advertise<SceneForecast>(names::kForecast, 1)),
      forecast_cloud_(node_.advertise<sensor_msgs::PointCloud2>(names::kForecastCloud, 1)),
      predicted_poses_(node_.advertise<geometry_msgs::PoseArray>(names::kPredictedPoses, 1)),
      markers_(node_.advertise<visualization_msgs::MarkerArray>(names::kMarkers, 1)) {}

void ForecastPublisher::publish(const SceneRollout& rollout) {
  forecast_.publish(to_forecast(rollout, {}, fixed_frame_));
  predicted_poses_.publish(poses_at(rollout, 1, fixed_frame_));
  if (forecast_cloud_.getNumSubscribers() > 0) {
    forecast_cloud_.publish(to_points_cloud(rollout, {}, fixed_frame_, /*first_step=*/1));
  }
  publish_object_points(rollout);
  if (with_markers_) {
    markers_.publish(visualizer_.draw(rollout));
  }
}

void ForecastPublisher::publish_object_points(const SceneRollout& rollout) {
  std::map<std::string, ros::Publisher> current;
  for (std::size_t i = 0; i < rollout.scene.objects.size(); ++i) {
    const std::string& id = rollout.scene.objects[i].state.id;
    const auto known = object_points_.find(id);
    ros::Publisher publisher = known != object_points_.end()
                                   ? known->second
                                   : node_.advertise<sensor_msgs::PointCloud2>(names::predicted_points(id), 1);
    if (publisher.getNumSubscribers() > 0) {
      publisher.publish(object_points_at(rollout, i, 1, fixed_frame_));
    }
    current[id] = publisher;
  }
  object_points_ = std::move(current);  // topics of vanished objects go with them
}

void ForecastPublisher::clear() {
  const visualization_msgs::MarkerArray removals = visualizer_.clear();
  if (!removals.markers.empty()) {
    markers_.publish(removals);
  }
}

}  // namespace rigidformer_ros
