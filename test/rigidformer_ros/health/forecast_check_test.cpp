// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/health/forecast_check.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

// [s]. A round number that makes the horizons easy to read; the check takes any step.
constexpr double kTimeStep = 0.1;
// [rad]
constexpr double kDegree = 3.14159265358979323846 / 180.0;

/// The true motion of every object: it moves along x with 1 m/s and turns about z with 90 degrees per second.
RigidTransform truth(double t) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(90.0 * kDegree * t, Eigen::Vector3d::UnitZ())), {t, 0.0, 0.0}};
}

/// A forecast of the objects `ids` from t0. With every step its position error grows by `position_error_m` and its
/// rotation error by `angle_error_rad`.
SceneRollout forecast(const std::vector<std::string>& ids, double t0, double position_error_m, double angle_error_rad,
                      int steps = 4, std::uint64_t track = 7) {
  SceneRollout rollout;
  rollout.scene.stamp = rigidformer::stamp_at(t0);
  for (int k = 0; k <= steps; ++k) {
    rollout.outcome.forecast.times_s.push_back(k * kTimeStep);
  }
  for (const std::string& id : ids) {
    ObservedObject object;
    object.state.id = id;
    object.track = track;
    rollout.scene.objects.push_back(object);
    rigidformer::ObjectTrajectory predicted{id, rigidformer::ObjectTrajectory::Status::kOk, {}};
    for (int k = 0; k <= steps; ++k) {
      RigidTransform pose = truth(t0 + k * kTimeStep);
      pose.translation.y() += k * position_error_m;
      pose.rotation = Eigen::AngleAxisd(k * angle_error_rad, Eigen::Vector3d::UnitX()) * pose.rotation;
      predicted.poses.push_back(pose);
    }
    rollout.outcome.forecast.objects.push_back(predicted);
  }
  return rollout;
}

/// The record of a track that saw the true motion at 30 Hz from time `from` to time `to` [s].
TrackRecord seen(double from, double to, std::uint64_t track = 7) {
  TrackRecord record;
  record.track = track;
  for (int i = 0; from + i / 30.0 <= to + 1e-9; ++i) {
    record.poses.add(rigidformer::stamp_at(from + i / 30.0), truth(from + i / 30.0), 0.005);
  }
  return record;
}

TEST(ForecastCheck, MeasuresTheErrorAtEveryHorizonBetweenTheClouds) {
  ForecastCheck check(60.0);
  check.expect(forecast({"a"}, 10.0, 0.02, 3.0 * kDegree));
  EXPECT_EQ(check.compare({{"a", seen(9.5, 10.41)}}), 4);
  const std::vector<HorizonError> errors = check.errors();
  ASSERT_EQ(errors.size(), 4U);
  for (int k = 1; k <= 4; ++k) {
    EXPECT_NEAR(errors[k - 1].horizon_s, k * kTimeStep, 1e-9);
    EXPECT_NEAR(errors[k - 1].position_rmse_m, 0.02 * k, 1e-7);
    EXPECT_NEAR(errors[k - 1].rotation_rmse_rad, 3.0 * kDegree * k, 1e-6);
    EXPECT_EQ(errors[k - 1].num_samples, 1U);
  }
}

TEST(ForecastCheck, IsTheRootMeanSquareOverObjectsAndForecasts) {
  ForecastCheck check(60.0);
  check.expect(forecast({"a"}, 10.0, 0.3, 0.0, 1));
  check.expect(forecast({"b"}, 10.1, 0.4, 0.0, 1));
  EXPECT_EQ(check.compare({{"a", seen(9.5, 10.5)}, {"b", seen(9.5, 10.5)}}), 2);
  ASSERT_EQ(check.errors().size(), 1U);
  EXPECT_NEAR(check.errors()[0].position_rmse_m, std::sqrt((0.09 + 0.16) / 2.0), 1e-7);
  EXPECT_EQ(check.errors()[0].num_samples, 2U);
}

TEST(ForecastCheck, ComparesEachHorizonOnceWhenItHasBeenSeen) {
  ForecastCheck check(60.0);
  check.expect(forecast({"a"}, 10.0, 0.02, 0.0));
  EXPECT_EQ(check.compare({{"a", seen(9.5, 10.05)}}), 0) << "nothing is extrapolated";
  EXPECT_EQ(check.compare({{"a", seen(9.5, 10.25)}}), 2);
  EXPECT_EQ(check.compare({{"a", seen(9.5, 10.25)}}), 0);
  EXPECT_EQ(check.compare({{"a", seen(9.5, 10.45)}}), 2);
  EXPECT_EQ(check.compare({{"a", seen(9.5, 10.9)}}), 0);
}

TEST(ForecastCheck, ARestartedOrVanishedTrackDoesNotCount) {
  ForecastCheck check(60.0);
  check.expect(forecast({"a", "b"}, 10.0, 0.02, 0.0));
  EXPECT_EQ(check.compare({{"a", seen(10.1, 10.6, 8)}}), 0);
  EXPECT_EQ(check.compare({{"a", seen(9.5, 10.6)}, {"b", seen(9.5, 10.6)}}), 0) << "dropped for good";
}

TEST(ForecastCheck, OnlyGoodForecastsOfDynamicObjectsCount) {
  SceneRollout rollout = forecast({"still", "poor", "static", "lost", "good"}, 10.0, 0.02, 0.0);
  rollout.scene.objects[0].assumed_static = true;
  rollout.scene.objects[1].low_quality = true;
  rollout.scene.objects[2].state.mode = rigidformer::MotionMode::kStatic;
  rollout.outcome.forecast.objects[3].status = rigidformer::ObjectTrajectory::Status::kDiverged;
  TrackRecords records;
  for (const ObservedObject& object : rollout.scene.objects) {
    records[object.state.id] = seen(9.5, 10.6);
  }
  ForecastCheck check(60.0);
  check.expect(rollout);
  EXPECT_EQ(check.compare(records), 4);
  check.expect(forecast({"good"}, 10.0, 0.02, 0.0));
  records["good"].low_quality = true;
  EXPECT_EQ(check.compare(records), 0) << "a bad observation is no measure of a forecast";
}

TEST(ForecastCheck, OldErrorsLeaveTheWindow) {
  ForecastCheck check(10.0);
  check.expect(forecast({"a"}, 10.0, 0.5, 0.0, 1));
  check.compare({{"a", seen(9.5, 10.5)}});
  check.expect(forecast({"a"}, 15.0, 0.1, 0.0, 1));
  check.compare({{"a", seen(14.5, 15.5)}});
  EXPECT_NEAR(check.errors()[0].position_rmse_m, std::sqrt((0.25 + 0.01) / 2.0), 1e-7);
  check.expect(forecast({"a"}, 22.0, 0.1, 0.0, 1));
  check.compare({{"a", seen(21.5, 22.5)}});
  EXPECT_NEAR(check.errors()[0].position_rmse_m, 0.1, 1e-7);
  EXPECT_EQ(check.errors()[0].num_samples, 2U);
  check.reset();
  EXPECT_TRUE(check.errors().empty());
}

TEST(ForecastCheck, AJumpBackInTimeNeedsAReset) {
  ForecastCheck check(10.0);
  check.expect(forecast({"a"}, 1000.0, 0.5, 0.0, 1));
  check.compare({{"a", seen(999.5, 1000.5)}});
  check.reset();
  check.expect(forecast({"a"}, 10.0, 0.1, 0.0, 1, 8));
  EXPECT_EQ(check.compare({{"a", seen(9.5, 10.5, 8)}}), 1);
  EXPECT_NEAR(check.errors()[0].position_rmse_m, 0.1, 1e-7);
}

TEST(ForecastCheck, KeepsABoundedNumberOfForecasts) {
  ForecastCheck check(60.0);
  const SceneRollout rollout = forecast({"a"}, 10.0, 0.02, 0.0, 999);
  for (int i = 0; i < 500; ++i) {
    check.expect(rollout);
  }
  EXPECT_EQ(check.compare({{"a", seen(9.5, 10.15)}}), 100) << "100000 poses in forecasts of 1000 poses each";
}

TEST(ForecastCheck, TheTrustedHorizonEndsBeforeTheFirstLargeOrUncertainError) {
  const std::vector<HorizonError> errors{
      {0.1, 0.01, 0.1, 50}, {0.2, 0.05, 0.2, 40}, {0.3, 0.09, 0.3, 12}, {0.4, 0.01, 0.1, 9}};
  EXPECT_EQ(trusted_horizon_s(errors, 0.1, 0.3), 0.3) << "nine comparisons are too few";
  EXPECT_EQ(trusted_horizon_s(errors, 0.05, 1.0), 0.2);
  EXPECT_EQ(trusted_horizon_s(errors, 1.0, 0.15), 0.1);
  EXPECT_EQ(trusted_horizon_s(errors, 0.005, 1.0), 0.0);
  EXPECT_EQ(trusted_horizon_s({}, 1.0, 1.0), 0.0);
}

TEST(ForecastCheck, TheMessageHoldsAllHorizons) {
  const ForecastError message = to_message({{{0.1, 0.01, 0.2, 50}, {0.2, 0.05, 0.3, 40}}, 0.2}, 60.0);
  EXPECT_EQ(message.horizons, std::vector<double>({0.1, 0.2}));
  EXPECT_EQ(message.position_rmse, std::vector<double>({0.01, 0.05}));
  EXPECT_EQ(message.rotation_rmse, std::vector<double>({0.2, 0.3}));
  EXPECT_EQ(message.num_samples, std::vector<std::uint64_t>({50, 40}));
  EXPECT_EQ(message.window, 60.0);
  EXPECT_EQ(message.trusted_horizon, 0.2);
}

}  // namespace
}  // namespace rigidformer_ros
