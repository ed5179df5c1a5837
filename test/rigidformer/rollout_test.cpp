// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/rollout.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/box_scene.hpp"

namespace rigidformer {
namespace {

TEST(Outcomes, TurningAboutTheVerticalIsNoTilt) {
  const RigidTransform start{rotation_about({0.4, 0.2, 0.1}), {0, 0, 0}};
  const auto turned = [&](const Eigen::Vector3d& turn) {
    return RigidTransform{rotation_about(turn) * start.rotation, {0, 0, 0}};
  };
  EXPECT_NEAR(max_tilt({start, turned({0, 0, 2.0})}), 0.0, 1e-9);
  EXPECT_NEAR(max_tilt({start, turned({0.5, 0, 0}), turned({0.1, 0, 0})}), 0.5, 1e-9);
  EXPECT_NEAR(max_tilt({start, turned({0, M_PI, 0})}), M_PI, 1e-9);
}

TEST(Outcomes, ThePathIsLongerThanTheWay) {
  EXPECT_NEAR(path_length({at(0, 0, 0), at(1, 0, 0), at(1, 2, 0), at(0, 2, 0)}), 4.0, 1e-12);
}

TEST(Outcomes, SpansJoinTheStepsOfAPair) {
  Forecast forecast;
  forecast.contacts = {{0, 1, -1, 0.1}, {2, 1, -1, 0.3, 4.0}, {2, 1, 0, 0.0}, {5, 1, -1, 0.2, 3.0}};
  const auto spans = contact_spans(forecast);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_EQ(spans[0].first_step, 0);
  EXPECT_EQ(spans[0].last_step, 5);
  EXPECT_EQ(spans[0].max_penetration_m, 0.3);
  EXPECT_EQ(spans[0].max_normal_impulse_Ns, 4.0);
  EXPECT_TRUE(std::isnan(spans[1].max_normal_impulse_Ns));
  EXPECT_EQ(first_contact_step(forecast, 0), 2);
  EXPECT_EQ(first_contact_step(forecast, 1), 0);
  EXPECT_EQ(first_contact_step(forecast, 2), -1);
}

}  // namespace
}  // namespace rigidformer
