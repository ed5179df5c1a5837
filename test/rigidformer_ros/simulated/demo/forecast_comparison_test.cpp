// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/demo/forecast_comparison.hpp"

#include <gtest/gtest.h>

namespace rigidformer_ros::demo {
namespace {

ObjectForecast motion(const std::string& id, const std::vector<double>& heights) {
  ObjectForecast object;
  object.id = id;
  for (const double height : heights) {
    geometry_msgs::Pose pose;
    pose.position.z = height;
    object.poses.push_back(pose);
  }
  return object;
}

SceneForecast scene(double stamp, double step, const ObjectForecast& object) {
  SceneForecast forecast;
  forecast.header.stamp = ros::Time(stamp);
  forecast.time_step = step;
  for (std::size_t k = 0; k < object.poses.size(); ++k) {
    forecast.times.push_back(static_cast<double>(k) * step);
  }
  forecast.objects.push_back(object);
  return forecast;
}

TEST(PositionAt, IsLinearBetweenTimesAndEmptyOutside) {
  const ObjectForecast object = motion("a", {1.0, 3.0, 2.0});
  const std::vector<double> times{0.0, 0.5, 1.0};
  EXPECT_DOUBLE_EQ(position_at(times, object, 0.0)->z(), 1.0);
  EXPECT_DOUBLE_EQ(position_at(times, object, 0.25)->z(), 2.0);
  EXPECT_DOUBLE_EQ(position_at(times, object, 0.75)->z(), 2.5);
  EXPECT_DOUBLE_EQ(position_at(times, object, 1.0)->z(), 2.0);
  EXPECT_FALSE(position_at(times, object, 1.1).has_value());
  EXPECT_FALSE(position_at(times, object, -0.1).has_value());
}

TEST(PositionAt, RefusesPosesThatDoNotMatchTheTimes) {
  EXPECT_FALSE(position_at({0.0, 0.5}, motion("a", {1.0}), 0.0).has_value());
  EXPECT_FALSE(position_at({}, motion("a", {}), 0.0).has_value());
}

TEST(Compare, MeasuresFromTheStampOfTheForecast) {
  // The object really rises by 1 m per second. The forecast, made 1 s after the start, expects it to stand still.
  const SceneForecast truth = scene(10.0, 0.5, motion("a", {0.0, 0.5, 1.0, 1.5, 2.0}));
  const SceneForecast forecast = scene(11.0, 0.5, motion("a", {1.0, 1.0, 1.0}));
  const auto comparisons = compare(forecast, truth, {0.5, 1.0}, /*gravity=*/0.0);
  ASSERT_EQ(comparisons.size(), 2u);
  EXPECT_NEAR(comparisons[0].error_m(), 0.5, 1e-9);
  EXPECT_NEAR(comparisons[1].error_m(), 1.0, 1e-9);
  EXPECT_NEAR(comparisons[1].ballistic_error_m(), 0.0, 1e-9);
}

TEST(Compare, LeavesOutUnknownObjectsAndHorizonsBeyondTheTruth) {
  const SceneForecast truth = scene(10.0, 0.5, motion("a", {0.0, 0.5, 1.0, 1.5}));
  EXPECT_TRUE(compare(scene(11.0, 0.5, motion("b", {1.0, 1.0})), truth, {0.5}).empty());
  EXPECT_EQ(compare(scene(11.0, 0.5, motion("a", {1.0, 1.0, 1.0})), truth, {0.5, 1.0}).size(), 1u);
}

}  // namespace
}  // namespace rigidformer_ros::demo
