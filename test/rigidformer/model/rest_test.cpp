// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/rest.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigidformer {
namespace {

const auto kFloat = torch::TensorOptions(torch::kFloat32);

Tensor turn_about_z(double angle) {
  const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  return torch::tensor({c, -s, 0.0f, s, c, 0.0f, 0.0f, 0.0f, 1.0f}, kFloat).view({1, 1, 3, 3});
}

/// One object that moves at one speed [m/s] and spin [rad/s] over the last step, and at another over the next.
struct Motion {
  SceneBatch batch;
  SceneState last, next;

  Motion(double step_frames, double speed, double spin, double next_speed, double next_spin) {
    batch.step_size = torch::full({1}, step_frames, kFloat);
    batch.gravity = torch::full({1}, -10.0, kFloat);
    batch.dynamic_mask = torch::ones({1, 1}, torch::kBool);
    const double dt = step_frames / kFrameRateHz;
    const auto at = [](double x, double angle) {
      return Pose{turn_about_z(angle), torch::tensor({static_cast<float>(x), 0.0f, 1.0f}, kFloat).view({1, 1, 3})};
    };
    last.previous = at(0.0, 0.0);
    last.current = at(speed * dt, spin * dt);
    next.previous = last.current;
    next.current = at((speed + next_speed) * dt, (spin + next_spin) * dt);
  }

  bool is_held(const RestLimits& limits = {}) {
    SceneState after = next;
    hold_resting(batch, last, after, limits);
    const bool held = torch::equal(after.current.translation, last.current.translation) &&
                      torch::equal(after.current.rotation, last.current.rotation);
    const bool unchanged = torch::equal(after.current.translation, next.current.translation) &&
                           torch::equal(after.current.rotation, next.current.rotation);
    EXPECT_NE(held, unchanged);
    return held;
  }
};

TEST(HoldResting, WhatSomebodyMovesIsExempt) {
  Motion motion(10, 0.05, 0.1, 0.05, 0.1);
  SceneState after = motion.next;
  hold_resting(motion.batch, motion.last, after, {}, torch::ones({1, 1}, torch::kBool));
  EXPECT_TRUE(torch::equal(after.current.translation, motion.next.current.translation));
  hold_resting(motion.batch, motion.last, after, {}, torch::zeros({1, 1}, torch::kBool));
  EXPECT_TRUE(torch::equal(after.current.translation, motion.last.current.translation));
}

TEST(HoldResting, HoldsWhatIsAndStaysSlow) {
  EXPECT_TRUE(Motion(10, 0.05, 0.1, 0.05, 0.1).is_held());
  EXPECT_FALSE(Motion(10, 0.15, 0.1, 0.05, 0.1).is_held());
  EXPECT_FALSE(Motion(10, 0.05, 0.1, 0.15, 0.1).is_held());
  EXPECT_FALSE(Motion(10, 0.05, 0.4, 0.05, 0.1).is_held());
  EXPECT_FALSE(Motion(10, 0.05, 0.1, 0.05, 0.4).is_held());
}

TEST(HoldResting, NoVelocityHasTwoForms) {
  Motion motion(10, 0.02, 0.1, 0.02, 0.1);
  const double dt = 10.0 / kFrameRateHz;
  // Free motion has just reached its highest point ...
  motion.last.previous.translation[0][0][2] -= 0.5 * 10.0 * dt * dt;
  EXPECT_TRUE(motion.is_held());
  motion.next.current.translation[0][0][2] -= 0.5 * 10.0 * dt * dt;  // ... and goes on to fall
  EXPECT_FALSE(motion.is_held());
}

TEST(HoldResting, LimitsAreMeant) {
  EXPECT_TRUE(Motion(10, 0.15, 0.1, 0.15, 0.1).is_held({0.2, 0.3}));
  EXPECT_FALSE(Motion(10, 0.05, 0.1, 0.05, 0.1).is_held({0.04, 0.3}));
  EXPECT_FALSE(Motion(10, 0.05, 0.1, 0.05, 0.1).is_held({0.2, 0.05}));
}

TEST(HoldResting, LetsGoWhatBeginsToFallAtEveryTimeStep) {
  for (const double step : {1.0, 2.0, 5.0, 10.0}) {
    const double fall_speed = 10.0 * step / kFrameRateHz;  // the first step of the recursion covers g dt^2
    EXPECT_FALSE(Motion(step, 0.0, 0.0, fall_speed, 0.0).is_held()) << step;
    EXPECT_TRUE(Motion(step, 0.0, 0.0, 0.2 * fall_speed, 0.0).is_held()) << step;
  }
}

TEST(HoldResting, LeavesObjectsWithAGivenMotionAlone) {
  Motion motion(10, 0.05, 0.1, 0.05, 0.1);
  motion.batch.dynamic_mask.fill_(false);
  EXPECT_FALSE(motion.is_held());
}

}  // namespace
}  // namespace rigidformer
