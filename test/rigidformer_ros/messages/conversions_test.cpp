// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/conversions.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "rigidformer_ros/messages/names.hpp"
#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

using testing::Flight;

TEST(Conversions, PoseRoundTripKeepsEveryNumber) {
  const RigidTransform T = Flight().pose(0.7);
  const RigidTransform back = to_transform(to_pose(T));
  EXPECT_LT((back.translation - T.translation).norm(), 1e-12);
  EXPECT_LT((back.rotation.coeffs() - T.rotation.coeffs()).norm(), 1e-12);
}

TEST(Conversions, RefusesPosesThatAreNone) {
  geometry_msgs::Pose pose;
  EXPECT_THROW(to_transform(pose), std::invalid_argument) << "all-zero quaternion";
  pose.orientation.w = 1.1;
  EXPECT_THROW(to_transform(pose), std::invalid_argument);
  pose.orientation.w = 1.0;
  pose.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(to_transform(pose), std::invalid_argument);
}

TEST(Conversions, TwistIsOriginVelocityAndSpinInWorldAxes) {
  Flight flight;
  flight.gravity = 0.0;
  const geometry_msgs::Twist twist = twist_between(flight.pose(0.3), flight.pose(0.35), 0.05);
  EXPECT_NEAR(twist.linear.x, 0.5, 1e-9);
  EXPECT_NEAR(twist.linear.z, 1.0, 1e-9);
  EXPECT_NEAR(twist.angular.x, 0.3, 1e-9);
  EXPECT_NEAR(twist.angular.y, 1.0, 1e-9);
  EXPECT_NEAR(twist.angular.z, -2.0, 1e-9);
}

TEST(Conversions, OnlyFlaggedPropertiesCount) {
  PhysicalProperties message;
  message.mass = 2.0;
  EXPECT_FALSE(to_properties(message).mass_kg);
  message.known = PhysicalProperties::MASS;
  EXPECT_EQ(to_properties(message).mass_kg, 2.0);
  message.mass = -1.0;
  EXPECT_THROW(to_properties(message), std::invalid_argument);
}

TEST(Conversions, TopicOfAnObjectIsALegalName) {
  EXPECT_EQ(names::predicted_points("cup_1"), "predicted/cup_1/points");
  EXPECT_EQ(names::predicted_points("red cup/#1"), "predicted/red_cup__1/points");
  EXPECT_EQ(names::path("red cup/#1"), "paths/red_cup__1");
}

SceneRollout falling_scene() {
  SceneRollout rollout;
  rollout.scene.stamp = rigidformer::Stamp(std::chrono::seconds(3) + std::chrono::nanoseconds(999));
  rollout.scene.time_step_s = 0.04;
  rollout.scene.skipped.push_back({"gone", "not seen"});
  for (int k = 0; k <= 6; ++k) {
    rollout.outcome.forecast.times_s.push_back(0.04 * k);
  }
  for (const char* id : {"a", "b"}) {
    ObservedObject object;
    object.state.id = id;
    object.state.points_reference = testing::blob(10);
    object.state.T_world_previous = Flight().pose(-0.04);
    object.state.T_world_current = Flight().pose(0.0);
    rollout.scene.objects.push_back(object);
    rigidformer::ObjectTrajectory forecast{id, rigidformer::ObjectTrajectory::Status::kOk, {}};
    for (int k = 0; k <= 6; ++k) {
      forecast.poses.push_back(Flight().pose(0.04 * k));
    }
    rollout.outcome.forecast.objects.push_back(forecast);
    rollout.outcome.settled_steps.push_back(-1);
  }
  return rollout;
}

TEST(ForecastMessages, RecordsEveryNthStepOfTheChosenObjects) {
  SceneRollout rollout = falling_scene();
  rollout.outcome.settled_steps = {-1, 3};
  const SceneForecast message = to_forecast(rollout, {{"b"}, 2}, "map");
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.header.stamp, ros::Time(3, 999));
  ASSERT_EQ(message.times.size(), 4U);
  EXPECT_EQ(message.times[0], 0.0);
  EXPECT_NEAR(message.times[3], 0.24, 1e-12);
  ASSERT_EQ(message.objects.size(), 1U);
  EXPECT_EQ(message.objects[0].id, "b");
  EXPECT_EQ(message.objects[0].poses.size(), 4U);
  EXPECT_EQ(message.objects[0].twists.size(), 4U);
  EXPECT_EQ(message.objects[0].settled_step, 2) << "first recorded step at or after step 3";
  EXPECT_NEAR(message.objects[0].poses[3].position.z, Flight().pose(0.24).translation.z(), 1e-12);
  EXPECT_TRUE(message.objects[0].position_stddev.empty());
  EXPECT_EQ(message.skipped_ids, std::vector<std::string>({"gone"}));
}

TEST(ForecastMessages, StatusSaysTheWorstThatIsKnown) {
  SceneRollout rollout = falling_scene();
  EXPECT_EQ(to_forecast(rollout, {}, "map").objects[0].status, ObjectForecast::OK);
  rollout.model.min_size_m = 10.0;
  rollout.model.max_size_m = 20.0;
  EXPECT_EQ(to_forecast(rollout, {}, "map").objects[0].status, ObjectForecast::OUT_OF_RANGE);
  rollout.scene.objects[0].assumed_static = true;
  EXPECT_EQ(to_forecast(rollout, {}, "map").objects[0].status, ObjectForecast::ASSUMED_STATIC);
  rollout.scene.objects[0].low_quality = true;
  EXPECT_EQ(to_forecast(rollout, {}, "map").objects[0].status, ObjectForecast::LOW_QUALITY);
  rollout.outcome.forecast.objects[0].status = rigidformer::ObjectTrajectory::Status::kDiverged;
  EXPECT_EQ(to_forecast(rollout, {}, "map").objects[0].status, ObjectForecast::DIVERGED);
  EXPECT_EQ(to_forecast(rollout, {}, "map").objects[1].status, ObjectForecast::OUT_OF_RANGE);
}

TEST(ForecastMessages, WhatIsSeenInPartIsIncomplete) {
  const auto status = [](const SceneRollout& rollout) { return to_forecast(rollout, {}, "map").objects[0].status; };
  SceneRollout rollout = falling_scene();
  rollout.model.engine_steps_per_s = 100.0;
  EXPECT_EQ(status(rollout), ObjectForecast::OK) << "it falls";
  rollout.scene.objects[0].state.stood_s = 1.0;
  EXPECT_EQ(status(rollout), ObjectForecast::INCOMPLETE) << "it stands on nothing that is seen";
  rollout.model.engine_steps_per_s = 0.0;
  EXPECT_EQ(status(rollout), ObjectForecast::OK) << "without Bullet nobody knows";
  rollout.model.engine_steps_per_s = 100.0;
  rollout.outcome.forecast.contacts = {{0, 0, -1}};
  EXPECT_EQ(status(rollout), ObjectForecast::OK);
  rollout.scene.objects[0].state.points_reference.col(2).setZero();
  EXPECT_EQ(status(rollout), ObjectForecast::INCOMPLETE) << "a sheet";
  rollout.scene.objects[0].state.mode = rigidformer::MotionMode::kStatic;
  EXPECT_EQ(status(rollout), ObjectForecast::OK) << "nothing is predicted of it";
}

TEST(ForecastMessages, CloudsHoldTheRightPointsAtTheRightTimes) {
  const SceneRollout rollout = falling_scene();
  const sensor_msgs::PointCloud2 cloud = to_points_cloud(rollout, {{}, 3}, "map");
  EXPECT_EQ(cloud.width, 2U * 10U * 3U);
  EXPECT_EQ(count_points(rollout.scene, {{}, 3}, 6), cloud.width);
  EXPECT_EQ(to_points_cloud(rollout, {{}, 3}, "map", 1).width, 2U * 10U * 2U);
  const sensor_msgs::PointCloud2 next = object_points_at(rollout, 1, 1, "map");
  EXPECT_EQ(next.width, 10U);
  EXPECT_EQ(next.header.stamp, ros::Time(3, 999) + ros::Duration(0.04));
  EXPECT_EQ(poses_at(rollout, 1, "map").poses.size(), 2U);
}

TEST(ForecastMessages, APathHasAStampForEveryPose) {
  const nav_msgs::Path path = path_of(falling_scene(), 1, "map");
  EXPECT_EQ(path.header.frame_id, "map");
  EXPECT_EQ(path.header.stamp, ros::Time(3, 999));
  ASSERT_EQ(path.poses.size(), 7U);
  for (int k = 0; k <= 6; ++k) {
    EXPECT_EQ(path.poses[k].header.frame_id, "map");
    EXPECT_EQ(path.poses[k].header.stamp, ros::Time(3, 999 + k * 40000000));
    EXPECT_NEAR(path.poses[k].pose.position.z, Flight().pose(0.04 * k).translation.z(), 1e-12);
  }
}

}  // namespace
}  // namespace rigidformer_ros
