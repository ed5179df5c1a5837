// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/ballistic.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rigidformer {
namespace {

constexpr double kGravity = -10.0;  // [m/s^2] as in the MOVi scenes

/// Pose in free flight with constant spin, in closed form.
RigidTransform flight(double t) {
  const Eigen::Vector3d start(1.0, -2.0, 3.0);
  const Eigen::Vector3d velocity(0.5, 2.0, 4.0);
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 0, 1).normalized()));
  const Eigen::Quaterniond spin(Eigen::AngleAxisd(7.0 * t, Eigen::Vector3d(2, -1, 0.5).normalized()));
  return {spin * turned, start + velocity * t + Eigen::Vector3d(0, 0, 0.5 * kGravity * t * t)};
}

ObjectState object_at(double t, double time_step_s, MotionMode mode) {
  ObjectState object;
  object.mode = mode;
  object.T_world_previous = flight(t - time_step_s);
  object.T_world_current = flight(t);
  return object;
}

RolloutOptions rollout_of(double time_step_s) {
  RolloutOptions rollout;
  rollout.num_steps = 20;
  rollout.time_step_s = time_step_s;
  rollout.gravity = kGravity;
  return rollout;
}

TEST(Ballistic, IsExactOnFreeFlightWithSpinAtEveryStepSize) {
  for (const double time_step_s : {1.0 / 240.0, 5.0 / 240.0, 10.0 / 240.0}) {
    const auto poses =
        BallisticForecaster().forecast({object_at(0.3, time_step_s, MotionMode::kDynamic)}, rollout_of(time_step_s));
    ASSERT_EQ(poses.size(), 1U);
    ASSERT_EQ(poses[0].size(), 21U);
    for (int k = 0; k <= 20; ++k) {
      const RigidTransform truth = flight(0.3 + k * time_step_s);
      EXPECT_NEAR((poses[0][k].translation - truth.translation).norm(), 0.0, 1e-10) << "step " << k;
      EXPECT_NEAR(rotation_angle(poses[0][k].rotation, truth.rotation), 0.0, 1e-7) << "step " << k;
    }
  }
}

TEST(Ballistic, KinematicObjectsKeepTheirTwistWithoutGravity) {
  const ObjectState object = object_at(0.3, 0.02, MotionMode::kKinematic);
  const auto poses = BallisticForecaster().forecast({object}, rollout_of(0.02));
  const Eigen::Vector3d increment = object.T_world_current.translation - object.T_world_previous.translation;
  const Eigen::Vector3d expected = object.T_world_current.translation + 20.0 * increment;
  EXPECT_NEAR((poses[0][20].translation - expected).norm(), 0.0, 1e-10);
}

TEST(Ballistic, StaticObjectsStay) {
  const auto poses = BallisticForecaster().forecast({object_at(0.3, 0.02, MotionMode::kStatic)}, rollout_of(0.02));
  ASSERT_EQ(poses[0].size(), 21U);
  EXPECT_EQ(poses[0][20].translation, flight(0.3).translation);
}

TEST(Ballistic, RefusesBadRollouts) {
  RolloutOptions rollout = rollout_of(0.02);
  rollout.num_steps = 0;
  EXPECT_THROW(BallisticForecaster().forecast({}, rollout), std::invalid_argument);
  EXPECT_THROW(BallisticForecaster().forecast({}, rollout_of(0.0)), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
