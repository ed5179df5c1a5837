// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace rigidformer {
namespace {

RigidTransform pose(double x, double y, double z, double yaw_deg = 0.0) {
  const Eigen::AngleAxisd yaw(yaw_deg * M_PI / 180.0, Eigen::Vector3d::UnitZ());
  return {Eigen::Quaterniond(yaw), {x, y, z}};
}

TEST(SceneError, IsZeroForTheTruth) {
  const PoseError error = scene_error({pose(1, 2, 3, 40)}, {pose(1, 2, 3, 40)});
  EXPECT_EQ(error.position_rmse_m, 0.0);
  EXPECT_NEAR(error.orientation_rmse_deg, 0.0, 1e-6);
}

TEST(SceneError, TakesTheRootOfTheMeanOverObjectsOfSquaredLengths) {
  // The distances are 5 (3-4-5 triangle) and 0: sqrt((25 + 0) / 2). The angles are 30 and 90
  // degrees: sqrt((900 + 8100) / 2).
  const PoseError error = scene_error({pose(3, 4, 0, 30), pose(0, 0, 1, 90)}, {pose(0, 0, 0), pose(0, 0, 1)});
  EXPECT_NEAR(error.position_rmse_m, std::sqrt(12.5), 1e-12);
  EXPECT_NEAR(error.orientation_rmse_deg, std::sqrt(4500.0), 1e-9);
}

TEST(SceneError, TakesTheShortWayRound) {
  EXPECT_NEAR(scene_error({pose(0, 0, 0, 350)}, {pose(0, 0, 0)}).orientation_rmse_deg, 10.0, 1e-9);
  RigidTransform flipped = pose(0, 0, 0, 20);
  flipped.rotation.coeffs() *= -1.0;
  EXPECT_NEAR(scene_error({flipped}, {pose(0, 0, 0)}).orientation_rmse_deg, 20.0, 1e-9);
}

TEST(SceneError, RefusesUnequalCounts) {
  EXPECT_THROW(scene_error({pose(0, 0, 0)}, {}), std::invalid_argument);
  EXPECT_THROW(scene_error({}, {}), std::invalid_argument);
}

TEST(MeanError, AveragesScenesAndNotObjects) {
  // One scene has one object 4 m off, the other two objects at the truth: the mean is (4 + 0) / 2, not sqrt(16 / 3).
  const PoseError far = scene_error({pose(4, 0, 0, 20)}, {pose(0, 0, 0)});
  const PoseError right = scene_error({pose(0, 0, 0), pose(1, 0, 0)}, {pose(0, 0, 0), pose(1, 0, 0)});
  const PoseError mean = mean_error({far, right});
  EXPECT_NEAR(mean.position_rmse_m, 2.0, 1e-12);
  EXPECT_NEAR(mean.orientation_rmse_deg, 10.0, 1e-9);
  EXPECT_THROW(mean_error({}), std::invalid_argument);
}

TEST(PoseAtStep, InterpolatesBetweenSteps) {
  const std::vector<RigidTransform> poses{pose(0, 0, 0), pose(2, 0, 4, 60), pose(2, 2, 4, 60)};
  EXPECT_EQ(pose_at_step(poses, 1.0).translation, Eigen::Vector3d(2, 0, 4));
  const RigidTransform quarter = pose_at_step(poses, 0.25);
  EXPECT_NEAR((quarter.translation - Eigen::Vector3d(0.5, 0, 1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(rotation_angle(quarter.rotation, pose(0, 0, 0, 15).rotation), 0.0, 1e-7);
  EXPECT_NEAR((pose_at_step(poses, 1.5).translation - Eigen::Vector3d(2, 1, 4)).norm(), 0.0, 1e-12);
  EXPECT_EQ(pose_at_step(poses, 2.0).translation, Eigen::Vector3d(2, 2, 4));
}

TEST(PoseAtStep, RefusesWhatWasNotForecast) {
  const std::vector<RigidTransform> poses{pose(0, 0, 0), pose(1, 0, 0)};
  EXPECT_THROW(pose_at_step(poses, 1.01), std::out_of_range);
  EXPECT_THROW(pose_at_step(poses, -0.01), std::out_of_range);
  EXPECT_THROW(pose_at_step(poses, std::numeric_limits<double>::quiet_NaN()), std::out_of_range);
  EXPECT_THROW(pose_at_step({}, 0.0), std::out_of_range);
}

}  // namespace
}  // namespace rigidformer
