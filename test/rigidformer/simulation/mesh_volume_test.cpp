// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/mesh_volume.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/baselines/engine_scenes.hpp"
#include "rigidformer/simulation/convex_hull.hpp"

namespace rigidformer {
namespace {

TEST(MeshVolume, BoxAnywhere) {
  const Eigen::Vector3d centre(3.0, -1.0, 2.0);
  const MeshVolume box = measure_volume(convex_hull(box_cloud({0.5, 1.0, 2.0}, centre)));
  EXPECT_NEAR(box.volume_m3, 1.0, 1e-5);
  EXPECT_LT((box.centroid - centre).norm(), 1e-5);
}

TEST(MeshVolume, PyramidHasItsCentroidAQuarterUp) {
  Points pyramid(5, 3);
  pyramid << 1, 1, 0, -1, 1, 0, -1, -1, 0, 1, -1, 0, 0, 0, 2;
  const MeshVolume measured = measure_volume(convex_hull(pyramid));
  EXPECT_NEAR(measured.volume_m3, 8.0 / 3.0, 1e-5);
  EXPECT_LT((measured.centroid - Eigen::Vector3d(0.0, 0.0, 0.5)).norm(), 1e-5);
}

TEST(MeshVolume, InertiaOfABoxAndOfABall) {
  const Eigen::Vector3d size(0.5, 1.0, 2.0);
  const Eigen::Matrix3d box = inertia_per_mass(convex_hull(box_cloud(size, Eigen::Vector3d::Zero())));
  const Eigen::Vector3d square = size.cwiseAbs2();
  const Eigen::Vector3d expected = (Eigen::Vector3d::Constant(square.sum()) - square) / 12.0;
  EXPECT_LT((box - Eigen::Matrix3d(expected.asDiagonal())).norm(), 1e-5);

  constexpr int kPoints = 4000;
  Points ball(kPoints, 3);  // a spiral that covers the sphere evenly
  for (int i = 0; i < kPoints; ++i) {
    const float z = 1.0F - (2.0F * static_cast<float>(i) + 1.0F) / kPoints, turn = 2.399963F * static_cast<float>(i);
    ball.row(i) << std::sqrt(1.0F - z * z) * std::cos(turn), std::sqrt(1.0F - z * z) * std::sin(turn), z;
  }
  const Eigen::Matrix3d inertia = inertia_per_mass(convex_hull(ball));
  EXPECT_LT((inertia - 0.4 * Eigen::Matrix3d::Identity()).norm(), 2e-3);
}

TEST(MeshVolume, InertiaTurnsWithTheBody) {
  const Points box = box_cloud({0.5, 1.0, 2.0}, Eigen::Vector3d::Zero());
  const Eigen::Quaterniond turn = rotation_about({0.3, -1.0, 0.5});
  const Eigen::Matrix3d R = turn.toRotationMatrix();
  const Eigen::Matrix3d before = inertia_per_mass(convex_hull(box));
  const Eigen::Matrix3d after = inertia_per_mass(convex_hull(RigidTransform{turn, {0.0, 0.0, 0.0}}.apply(box)));
  // Bullet rounds the corners of a hull to 1 / 10,216 of its extent, here 2 m.
  EXPECT_LT((after - R * before * R.transpose()).norm(), 2e-4);
}

}  // namespace
}  // namespace rigidformer
