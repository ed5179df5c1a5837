// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/rigid_registration.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

namespace rigidformer {
namespace {

Points random_points(int count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> coordinate(-0.5F, 0.5F);
  return Points::NullaryExpr(count, 3, [&] { return coordinate(generator); });
}

const RigidTransform kMotion{Eigen::Quaterniond(Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, -2, 0.5).normalized())),
                             Eigen::Vector3d(3.0, -1.0, 0.25)};

void expect_same(const RigidTransform& a, const RigidTransform& b, double tolerance) {
  EXPECT_LT((a.translation - b.translation).norm(), tolerance);
  EXPECT_LT(rotation_angle(a.rotation, b.rotation), tolerance);
}

TEST(RigidRegistration, RecoversAKnownMotion) {
  const Points source = random_points(40, 1);
  const RigidTransform T = fit_rigid_transform(source, kMotion.apply(source));
  expect_same(T, kMotion, 2e-6);
  EXPECT_LT(registration_residuals(T, source, kMotion.apply(source)).maxCoeff(), 2e-6);
}

TEST(RigidRegistration, NeverReflectsAPlanarCloud) {
  Points source = random_points(20, 2);
  source.col(2).setZero();
  expect_same(fit_rigid_transform(source, kMotion.apply(source)), kMotion, 2e-6);
}

TEST(RigidRegistration, IsTheLeastSquaresMotion) {
  const Points source = random_points(30, 3);
  const Points target = kMotion.apply(source) + 0.02F * random_points(30, 4);
  const RigidTransform best = fit_rigid_transform(source, target);
  const double error = registration_residuals(best, source, target).squaredNorm();
  for (int axis = 0; axis < 3; ++axis) {
    RigidTransform shifted = best;
    shifted.translation[axis] += 1e-3;
    EXPECT_GT(registration_residuals(shifted, source, target).squaredNorm(), error);
    RigidTransform turned = best;
    turned.rotation = best.rotation * Eigen::AngleAxisd(2e-3, Eigen::Vector3d::Unit(axis));
    EXPECT_GT(registration_residuals(turned, source, target).squaredNorm(), error);
  }
}

TEST(RigidRegistration, RejectsWhatItCannotFit) {
  const Points points = random_points(5, 5);
  EXPECT_THROW(fit_rigid_transform(points, random_points(4, 5)), std::invalid_argument);
  EXPECT_THROW(fit_rigid_transform(random_points(2, 5), random_points(2, 6)), std::invalid_argument);
  Points broken = points;
  broken(3, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(fit_rigid_transform(points, broken), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
