// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/outputs/forecast_publisher.hpp"

#include <vector>

#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "rigidformer_ros/messages/conversions.hpp"
#include "rigidformer_ros/messages/names.hpp"

namespace rigidformer_ros {

ForecastPublisher::ForecastPublisher(ros::NodeHandle& node, const NodeParameters& parameters)
    : fixed_frame_(parameters.fixed_frame),
      check_window_s_(parameters.diagnostics.check_window),
      with_markers_(parameters.display.markers),
      visualizer_(parameters.display, parameters.fixed_frame),
      forecast_(node.advertise<SceneForecast>(names::kForecast, 1)),
      forecast_cloud_(node.advertise<sensor_msgs::PointCloud2>(names::kForecastCloud, 1)),
      predicted_poses_(node.advertise<geometry_msgs::PoseArray>(names::kPredictedPoses, 1)),
      markers_(node.advertise<visualization_msgs::MarkerArray>(names::kMarkers, 1)),
      forecast_error_(node.advertise<ForecastError>(names::kForecastError, 1)),
      object_points_(node, names::predicted_points),
      paths_(node, names::path) {}

void ForecastPublisher::publish(const SceneRollout& rollout) {
  forecast_.publish(to_forecast(rollout, {}, fixed_frame_));
  predicted_poses_.publish(poses_at(rollout, 1, fixed_frame_));
  if (forecast_cloud_.getNumSubscribers() > 0) {
    forecast_cloud_.publish(to_points_cloud(rollout, {}, fixed_frame_, /*first_step=*/1));
  }
  publish_objects(rollout);
  if (with_markers_) {
    markers_.publish(visualizer_.draw(rollout));
  }
}

void ForecastPublisher::publish_objects(const SceneRollout& rollout) {
  std::vector<std::string> ids;
  for (const ObservedObject& object : rollout.scene.objects) {
    ids.push_back(object.state.id);
  }
  object_points_.set_objects(ids);
  paths_.set_objects(ids);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    object_points_.publish(ids[i], [&] { return object_points_at(rollout, i, 1, fixed_frame_); });
    paths_.publish(ids[i], [&] { return path_of(rollout, i, fixed_frame_); });
  }
}

void ForecastPublisher::publish(const ForecastQuality& quality, rigidformer::Stamp stamp) {
  ForecastError message = to_message(quality, check_window_s_);
  message.header.frame_id = fixed_frame_;
  message.header.stamp = to_ros_time(stamp);
  forecast_error_.publish(message);
}

void ForecastPublisher::clear() {
  clear_markers();
  object_points_.set_objects({});
  paths_.set_objects({});
}

void ForecastPublisher::clear_markers() {
  const visualization_msgs::MarkerArray removals = visualizer_.clear();
  if (!removals.markers.empty()) {
    markers_.publish(removals);
  }
}

void ForecastPublisher::set_display(const DisplayParameters& display) {
  visualizer_.set_display(display);
  with_markers_ = display.markers;
  if (!with_markers_) {
    clear_markers();
  }
}

}  // namespace rigidformer_ros
