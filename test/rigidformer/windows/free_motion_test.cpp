// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/free_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/model/random_scene.hpp"

namespace rigidformer {
namespace {

const auto kWide = torch::TensorOptions(torch::kFloat64);
constexpr double kFrame_s = 1.0 / kFrameRateHz;  // [s]

/// One object that spins about z and follows height(t).
template <typename Height>
Pose pose_at(double t, double spin, Height&& height) {
  const double c = std::cos(spin * t), s = std::sin(spin * t);
  return {torch::tensor({c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0}, kWide).view({1, 1, 3, 3}),
          torch::tensor({2.0 * t, -t, height(t)}, kWide).view({1, 1, 3})};
}

template <typename Height>
Pose departure(double step_size, double spin, Height&& height, double frame_s = kFrame_s) {
  SceneBatch scene;
  scene.step_size = torch::full({1}, step_size, kWide);
  scene.gravity = torch::full({1}, -10.0, kWide);
  return free_motion_departure(pose_at(-2.0 * frame_s, spin, height), pose_at(-frame_s, spin, height),
                               pose_at(0.0, spin, height), scene, torch::full({1}, 1.0 / frame_s, kWide));
}

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_LT(largest_difference(a.translation, b.translation), 1e-12);
  EXPECT_LT(largest_difference(a.rotation, b.rotation), 1e-9);
}

TEST(FreeMotionDeparture, OfFreeFlightIsThePoseAStepBefore) {
  const auto height = [](double t) { return 3.0 + 4.0 * t - 5.0 * t * t; };
  for (const double s : {1.0, 3.0, 10.0}) {
    expect_same(departure(s, 7.0, height), pose_at(-s * kFrame_s, 7.0, height));
  }
}

TEST(FreeMotionDeparture, FramesOfTheRecordingMayBeLongerThanThoseOfTheStep) {
  const auto height = [](double t) { return 3.0 + 4.0 * t - 5.0 * t * t; };
  expect_same(departure(9.0, 2.0, height, 1.0 / 53.5), pose_at(-9.0 * kFrame_s, 2.0, height));
}

TEST(FreeMotionDeparture, WhatIsCarriedDoesNotFall) {
  const auto height = [](double) { return 0.5; };
  expect_same(departure(10.0, 2.0, height), pose_at(-10.0 * kFrame_s, 2.0, height));  // the object rolls
  expect_same(departure(10.0, 0.0, height), pose_at(-10.0 * kFrame_s, 0.0, height));
}

TEST(FreeMotionDeparture, AfterAnImpactTheNewVelocityCounts) {
  const auto bounce = [](double t) { return t < -kFrame_s ? 1.0 - 6.0 * (t + kFrame_s) : 1.0 + 3.0 * (t + kFrame_s); };
  const Pose before = departure(10.0, 0.0, bounce);
  const Pose now = pose_at(0.0, 0.0, bounce);
  const double rise = (now.translation - before.translation)[0][0][2].item<double>();
  EXPECT_NEAR(rise, 10.0 * 3.0 * kFrame_s, 0.01);  // it flies up at 3 m/s, whatever it did before
}

}  // namespace
}  // namespace rigidformer
