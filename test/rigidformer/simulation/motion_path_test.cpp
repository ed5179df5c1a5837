// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/motion_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace rigidformer {
namespace {

Eigen::VectorXd number(double value) { return Eigen::VectorXd::Constant(1, value); }

MonotoneSpline spline_through(const std::vector<std::pair<double, double>>& keys) {
  MonotoneSpline spline;
  for (const auto& [time_s, value] : keys) spline.add_key(time_s, number(value));
  return spline;
}

TEST(MonotoneSpline, PassesThroughItsKeysAndRestsOutside) {
  const auto spline = spline_through({{0.5, 1.0}, {1.0, 2.0}, {2.0, 2.5}});
  EXPECT_EQ(spline.at(-1.0)[0], 1.0);
  EXPECT_EQ(spline.at(0.5)[0], 1.0);
  EXPECT_NEAR(spline.at(1.0)[0], 2.0, 1e-12);
  EXPECT_EQ(spline.at(9.0)[0], 2.5);
  EXPECT_NEAR(spline.at(0.5 + 1e-4)[0], 1.0, 1e-6) << "it starts from rest";
  EXPECT_NEAR(spline.at(2.0 - 1e-4)[0], 2.5, 1e-6) << "and comes to rest";
}

TEST(MonotoneSpline, StaysBetweenItsKeysAndStandsBetweenEqualOnes) {
  const auto spline = spline_through({{0.0, 0.0}, {0.1, 1.0}, {1.0, 1.0}, {1.2, -3.0}, {2.0, -2.9}});
  double before = 0.0;
  for (double time_s = 0.0; time_s <= 2.0; time_s += 0.01) {
    const double value = spline.at(time_s)[0];
    EXPECT_TRUE(time_s >= 0.1 || value >= before);
    EXPECT_TRUE(time_s <= 0.1 || time_s >= 1.0 || std::abs(value - 1.0) < 1e-12);
    EXPECT_TRUE(time_s <= 1.0 || time_s >= 1.2 || value <= before);
    EXPECT_GE(value, -3.0 - 1e-12);
    before = value;
  }
}

TEST(MonotoneSpline, HasNoJumpOfVelocity) {
  const auto spline = spline_through({{0.0, 0.0}, {0.3, 1.0}, {1.0, 1.5}, {1.1, 4.0}, {2.0, 5.0}});
  constexpr double kStep = 1e-6;
  const auto velocity = [&](double time_s) { return (spline.at(time_s + kStep) - spline.at(time_s))[0] / kStep; };
  for (const double key_s : {0.3, 1.0, 1.1}) EXPECT_NEAR(velocity(key_s - kStep), velocity(key_s), 5e-3);
}

TEST(MonotoneSpline, RefusesKeysThatAreNotLaterOrHaveOtherNumbers) {
  MonotoneSpline spline;
  EXPECT_THROW(spline.at(0.0), std::invalid_argument);
  spline.add_key(1.0, number(0.0));
  EXPECT_THROW(spline.add_key(1.0, number(0.0)), std::invalid_argument);
  EXPECT_THROW(spline.add_key(2.0, Eigen::VectorXd::Zero(2)), std::invalid_argument);
}

TEST(MotionPath, AStateLeadsToWhereThePathIsAStepLater) {
  const MotionPath path = started_after(
      [](double time_s) {
        return RigidTransform{rotation_about({0.0, 0.0, time_s}), {time_s * time_s, 0.0, 1.0}};
      },
      2.0);
  const BodyState state = state_on(path, 3.0, 0.5);
  EXPECT_NEAR(state.T_world_object.translation.x(), 1.0, 1e-12);
  EXPECT_NEAR(state.velocity.x(), (1.5 * 1.5 - 1.0) / 0.5, 1e-12);
  EXPECT_NEAR(state.angular_velocity.z(), 1.0, 1e-12);
}

}  // namespace
}  // namespace rigidformer
