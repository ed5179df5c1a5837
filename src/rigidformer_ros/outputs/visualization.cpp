// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/outputs/visualization.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "rigidformer_ros/messages/conversions.hpp"

namespace rigidformer_ros {

namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr float kNearestAlpha = 0.7F;
constexpr float kFarthestAlpha = 0.12F;
constexpr float kDoubtAlpha = 0.15F;
// Two standard deviations of each coordinate hold about three quarters of a normal distribution in space.
constexpr double kDrawnStddevs = 2.0;

// A colour that depends on the id alone, so that an object keeps it: hue from the hash, fixed saturation and value.
std_msgs::ColorRGBA colour_of(const std::string& id, float alpha) {
  const float hue = static_cast<float>(std::hash<std::string>{}(id) % 360) / 60.0F;
  const auto channel = [hue](float offset) {
    const float k = std::fmod(offset + hue, 6.0F);
    return 0.95F - 0.7F * std::max(0.0F, std::min({k, 4.0F - k, 1.0F}));
  };
  std_msgs::ColorRGBA colour;
  colour.r = channel(5.0F);
  colour.g = channel(3.0F);
  colour.b = channel(1.0F);
  colour.a = alpha;
  return colour;
}

geometry_msgs::Point to_point(const Eigen::Vector3d& p) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

// The id, with what the status of the forecast warns of.
std::string label_of(const std::string& id, std::uint8_t status) {
  switch (status) {
    case ObjectForecast::ASSUMED_STATIC:
      return id + " (assumed static)";
    case ObjectForecast::LOW_QUALITY:
      return id + " (low quality)";
    case ObjectForecast::DIVERGED:
      return id + " (diverged)";
    case ObjectForecast::OUT_OF_RANGE:
      return id + " (out of range)";
    case ObjectForecast::INCOMPLETE:
      return id + " (incomplete)";
    default:
      return id;
  }
}

}  // namespace

ForecastVisualizer::ForecastVisualizer(const DisplayParameters& display, std::string fixed_frame)
    : display_(display), fixed_frame_(std::move(fixed_frame)) {}

Marker ForecastVisualizer::make_marker(rigidformer::Stamp stamp, const std::string& ns, int id, int type) const {
  Marker marker;
  marker.header.frame_id = fixed_frame_;
  marker.header.stamp = to_ros_time(stamp);
  marker.ns = ns;
  marker.id = id;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.lifetime = ros::Duration(display_.marker_lifetime);
  return marker;
}

Marker ForecastVisualizer::make_label(const SceneRollout& rollout, std::size_t index) const {
  const ObservedObject& object = rollout.scene.objects[index];
  const rigidformer::ObjectTrajectory& forecast = rollout.outcome.forecast.objects[index];
  const rigidformer::Points now = forecast.poses.front().apply(object.state.points_reference);
  Marker label = make_marker(rollout.scene.stamp, "label/" + object.state.id, 0, Marker::TEXT_VIEW_FACING);
  label.pose.position = to_point(forecast.poses.front().translation);
  label.pose.position.z = static_cast<double>(now.col(2).maxCoeff()) + display_.label_size;
  label.scale.z = display_.label_size;
  label.color = colour_of(object.state.id, 1.0F);
  label.text = label_of(object.state.id, status_of(rollout, index));
  return label;
}

Marker ForecastVisualizer::make_path(const SceneRollout& rollout, std::size_t index) const {
  const rigidformer::ObjectTrajectory& forecast = rollout.outcome.forecast.objects[index];
  Marker path = make_marker(rollout.scene.stamp, "path/" + forecast.id, 0, Marker::LINE_STRIP);
  path.scale.x = display_.path_width;
  path.color = colour_of(forecast.id, 1.0F);
  for (const rigidformer::RigidTransform& pose : forecast.poses) {
    path.points.push_back(to_point(pose.translation));
  }
  return path;
}

Marker ForecastVisualizer::make_ghost(const SceneRollout& rollout, std::size_t index, std::size_t step) const {
  const rigidformer::Points& points = rollout.scene.objects[index].state.points_reference;
  const rigidformer::ObjectTrajectory& forecast = rollout.outcome.forecast.objects[index];
  const float progress = static_cast<float>(step) / static_cast<float>(forecast.poses.size() - 1);
  const auto number = static_cast<int>(step / static_cast<std::size_t>(display_.ghost_every)) - 1;
  Marker ghost = make_marker(rollout.scene.stamp, "ghost/" + forecast.id, number, Marker::POINTS);
  ghost.pose = to_pose(forecast.poses[step]);
  ghost.scale.x = display_.point_size;
  ghost.scale.y = display_.point_size;
  ghost.color = colour_of(forecast.id, kNearestAlpha + progress * (kFarthestAlpha - kNearestAlpha));
  const Eigen::Index stride = (points.rows() - 1) / display_.max_ghost_points + 1;
  for (Eigen::Index i = 0; i < points.rows(); i += stride) {
    ghost.points.push_back(to_point(points.row(i).cast<double>()));
  }
  return ghost;
}

Marker ForecastVisualizer::make_doubt(const SceneRollout& rollout, std::size_t index, std::size_t step) const {
  const rigidformer::ObjectTrajectory& forecast = rollout.outcome.forecast.objects[index];
  const auto number = static_cast<int>(step / static_cast<std::size_t>(display_.ghost_every)) - 1;
  Marker doubt = make_marker(rollout.scene.stamp, "doubt/" + forecast.id, number, Marker::SPHERE);
  doubt.pose.position = to_point(forecast.poses[step].translation);
  doubt.scale.x = doubt.scale.y = doubt.scale.z = 2.0 * kDrawnStddevs * forecast.position_stddev_m[step];
  doubt.color = colour_of(forecast.id, kDoubtAlpha);
  return doubt;
}

void ForecastVisualizer::draw_object(const SceneRollout& rollout, std::size_t index, MarkerArray& markers) const {
  markers.markers.push_back(make_label(rollout, index));
  if (rollout.scene.objects[index].state.mode == rigidformer::MotionMode::kStatic) {
    return;  // its future is where it is
  }
  markers.markers.push_back(make_path(rollout, index));
  const auto every = static_cast<std::size_t>(display_.ghost_every);
  for (std::size_t k = every; k < rollout.outcome.forecast.times_s.size(); k += every) {
    markers.markers.push_back(make_ghost(rollout, index, k));
    if (k < rollout.outcome.forecast.objects[index].position_stddev_m.size()) {
      markers.markers.push_back(make_doubt(rollout, index, k));
    }
  }
}

MarkerArray ForecastVisualizer::draw(const SceneRollout& rollout) {
  MarkerArray markers;
  for (std::size_t i = 0; i < rollout.scene.objects.size(); ++i) {
    draw_object(rollout, i, markers);
  }
  return replace(std::move(markers));
}

MarkerArray ForecastVisualizer::clear() { return replace({}); }

MarkerArray ForecastVisualizer::replace(MarkerArray markers) {
  std::set<MarkerKey> current;
  for (const Marker& marker : markers.markers) {
    current.insert({marker.ns, marker.id});
  }
  for (const MarkerKey& key : drawn_) {
    if (current.count(key) == 0) {
      Marker removal = make_marker({}, key.first, key.second, Marker::POINTS);
      removal.action = Marker::DELETE;
      markers.markers.push_back(removal);
    }
  }
  drawn_ = std::move(current);
  return markers;
}

}  // namespace rigidformer_ros
