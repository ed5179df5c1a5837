// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/rigid_transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rigidformer {
namespace {

RigidTransform turn(double angle_rad, const Eigen::Vector3d& axis, const Eigen::Vector3d& translation) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis.normalized())), translation};
}

const RigidTransform kA = turn(0.7, {1, 2, 3}, {1, -2, 0.5});
const RigidTransform kB = turn(-2.1, {0, 1, -1}, {-3, 0.2, 4});

TEST(RigidTransform, MapsAPointByHand) {
  const RigidTransform quarter = turn(M_PI / 2, {0, 0, 1}, {10, 0, 0});
  EXPECT_NEAR((quarter * Eigen::Vector3d(1, 2, 3) - Eigen::Vector3d(8, 1, 3)).norm(), 0.0, 1e-12);
}

TEST(RigidTransform, CompositionAppliesTheRightOneFirst) {
  const Eigen::Vector3d p(0.3, -1.2, 2.0);
  EXPECT_NEAR(((kA * kB) * p - kA * (kB * p)).norm(), 0.0, 1e-12);
}

TEST(RigidTransform, InverseUndoes) {
  const Eigen::Vector3d p(0.3, -1.2, 2.0);
  EXPECT_NEAR((kA.inverse() * (kA * p) - p).norm(), 0.0, 1e-12);
  EXPECT_NEAR((kA * (kA.inverse() * p) - p).norm(), 0.0, 1e-12);
}

TEST(RigidTransform, ApplyMapsEveryRow) {
  Points points(3, 3);
  points << 1, 2, 3, -1, 0, 1, 0.5F, 0.25F, -4;
  const Points moved = kB.apply(points);
  for (int row = 0; row < 3; ++row) {
    const Eigen::Vector3d expected = kB * points.row(row).transpose().cast<double>();
    EXPECT_NEAR((moved.row(row).transpose().cast<double>() - expected).norm(), 0.0, 1e-5);
  }
}

TEST(RigidTransform, InterpolationMeetsItsEndsAndExtrapolates) {
  for (double fraction : {0.0, 1.0}) {
    const RigidTransform T = interpolate(kA, kB, fraction);
    const RigidTransform& end = fraction == 0.0 ? kA : kB;
    EXPECT_NEAR((T.translation - end.translation).norm(), 0.0, 1e-12);
    EXPECT_NEAR(rotation_angle(T.rotation, end.rotation), 0.0, 1e-7);
  }
  const RigidTransform beyond = interpolate(turn(0, {0, 0, 1}, {0, 0, 0}), turn(0.4, {0, 0, 1}, {1, 0, 0}), 2.5);
  EXPECT_NEAR(beyond.translation.x(), 2.5, 1e-12);
  EXPECT_NEAR(rotation_angle(beyond.rotation, turn(1.0, {0, 0, 1}, {0, 0, 0}).rotation), 0.0, 1e-7);
}

TEST(RigidTransform, InterpolationTakesTheShortWayForEitherSignOfTheQuaternion) {
  RigidTransform to = turn(0.6, {0, 0, 1}, {0, 0, 0});
  to.rotation.coeffs() *= -1.0;
  const RigidTransform half = interpolate(RigidTransform{}, to, 0.5);
  EXPECT_NEAR(rotation_angle(half.rotation, turn(0.3, {0, 0, 1}, {0, 0, 0}).rotation), 0.0, 1e-7);
}

TEST(RigidTransform, RotationVectorsAndRotationsAreInverse) {
  for (const double angle : {0.0, 1e-9, 0.3, 3.1}) {
    const Eigen::Vector3d vector = angle * Eigen::Vector3d(2.0, -1.0, 2.0) / 3.0;
    Eigen::Quaterniond rotation = rotation_about(vector);
    EXPECT_LT((rotation_vector(rotation) - vector).norm(), 1e-9);
    rotation.coeffs() *= -1.0;
    EXPECT_LT((rotation_vector(rotation) - vector).norm(), 1e-9) << "the same rotation";
  }
  EXPECT_LT((rotation_about({0.0, 0.0, M_PI / 2.0}) * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(),
            1e-12);
}

TEST(RigidTransform, RotationAngleIsGeodesicAndIgnoresQuaternionSign) {
  const Eigen::Quaterniond a = turn(0.25, {1, 1, 0}, {0, 0, 0}).rotation;
  Eigen::Quaterniond b = turn(1.5, {1, 1, 0}, {0, 0, 0}).rotation;
  EXPECT_NEAR(rotation_angle(a, b), 1.25, 1e-9);
  b.coeffs() *= -1.0;
  EXPECT_NEAR(rotation_angle(a, b), 1.25, 1e-9);
  EXPECT_NEAR(rotation_angle(a, a * turn(M_PI, {0, 1, 0}, {0, 0, 0}).rotation), M_PI, 1e-9);
}

TEST(RigidTransform, ValidityNeedsFiniteNumbersAndAUnitQuaternion) {
  EXPECT_TRUE(is_valid(kA));
  RigidTransform T = kA;
  T.translation.y() = std::nan("");
  EXPECT_FALSE(is_valid(T));
  T = kA;
  T.rotation.coeffs() *= 1.1;
  EXPECT_FALSE(is_valid(T));
  T.rotation.coeffs().setZero();
  EXPECT_FALSE(is_valid(T));
}

}  // namespace
}  // namespace rigidformer
