// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "rigidformer_ros/node/node_client.hpp"

namespace rigidformer_ros::testing {
namespace {

/// The first scene of the camera: all forecasts of it, and its true motion.
class WatchedScene {
 public:
  WatchedScene() {
    truths_ = node_.subscribe<SceneForecast>("camera/truth", 2, [this](const SceneForecast::ConstPtr& message) {
      is_over_ = is_over_ || truth_.has_value();
      truth_ = truth_ ? truth_ : std::optional<SceneForecast>(*message);
    });
    forecasts_ = node_.subscribe<SceneForecast>("forecast", 100, [this](const SceneForecast::ConstPtr& message) {
      if (!is_over_) {
        seen.push_back(*message);
      }
    });
  }

  bool is_over() const { return is_over_; }

  /// The true pose of an object at `stamp`. The result is empty before and after the scene and for unknown objects.
  std::optional<RigidTransform> pose(const std::string& id, const ros::Time& stamp) const {
    const double at = (stamp - truth_->header.stamp).toSec() / truth_->time_step;
    const auto object = std::find_if(truth_->objects.begin(), truth_->objects.end(),
                                     [&](const ObjectForecast& candidate) { return candidate.id == id; });
    if (object == truth_->objects.end() || at < -1e-3 || at > static_cast<double>(object->poses.size()) - 0.999) {
      return std::nullopt;
    }
    const auto before = std::min(static_cast<std::size_t>(std::max(at + 1e-6, 0.0)), object->poses.size() - 1);
    const auto after = std::min(before + 1, object->poses.size() - 1);
    return rigidformer::interpolate(to_transform(object->poses[before]), to_transform(object->poses[after]),
                                    at - static_cast<double>(before));
  }

  std::vector<SceneForecast> seen;

 private:
  ros::NodeHandle node_;
  ros::Subscriber truths_, forecasts_;
  std::optional<SceneForecast> truth_;
  bool is_over_ = false;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values.at(values.size() / 2);
}

TEST(DepthCamera, ObjectsAreTrackedAndForeseenThroughTheTopics) {
  WatchedScene scene;
  ASSERT_TRUE(NodeClient::wait_until([&] { return scene.is_over(); }, 280.0));
  const double horizon_s = ros::param::param("~horizon", 0.25);
  std::map<std::string, RigidTransform> T_reference_body;
  std::vector<double> position_errors, forecast_errors;
  for (const SceneForecast& forecast : scene.seen) {
    for (const ObjectForecast& object : forecast.objects) {
      const auto truth = scene.pose(object.id, forecast.header.stamp);
      ASSERT_TRUE(truth) << object.id;
      const RigidTransform observed = to_transform(object.poses.front());
      const auto [entry, is_new] = T_reference_body.try_emplace(object.id, observed.inverse() * *truth);
      if (!is_new) {
        position_errors.push_back(((observed * entry->second).translation - truth->translation).norm());
      }
      const auto step = static_cast<std::size_t>(std::lround(horizon_s / forecast.time_step));
      const auto happened = scene.pose(object.id, forecast.header.stamp + ros::Duration(forecast.times.at(step)));
      if (happened && object.status == ObjectForecast::OK) {
        const RigidTransform predicted = to_transform(object.poses.at(step)) * observed.inverse() * *truth;
        forecast_errors.push_back((predicted.translation - happened->translation).norm());
      }
    }
  }
  ASSERT_GT(position_errors.size(), 20U);
  ASSERT_GT(forecast_errors.size(), 20U);
  RecordProperty("median_position_error", std::to_string(median(position_errors)));
  RecordProperty("median_forecast_error", std::to_string(median(forecast_errors)));
  EXPECT_LT(median(position_errors), ros::param::param("~max_position_error", 0.0));
  EXPECT_LT(median(forecast_errors), ros::param::param("~max_forecast_error", 0.0));
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "depth_camera_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
