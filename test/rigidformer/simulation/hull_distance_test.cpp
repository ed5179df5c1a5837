// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/hull_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/baselines/engine_scenes.hpp"
#include "rigidformer/simulation/convex_hull.hpp"

namespace rigidformer {
namespace {

RigidTransform at(const Eigen::Vector3d& position, const Eigen::Vector3d& turn = Eigen::Vector3d::Zero()) {
  return {rotation_about(turn), position};
}

class HullDistance : public ::testing::Test {
 protected:
  SolidHull cube_{convex_hull(box_cloud({1.0, 1.0, 1.0}, Eigen::Vector3d::Zero()))};
};

TEST_F(HullDistance, BetweenFaces) {
  const auto closest = closest_points(cube_, at({1.25, 0.0, 0.0}), cube_, at({0.0, 0.0, 0.0}));
  ASSERT_TRUE(closest);
  EXPECT_NEAR(closest->gap_m, 0.25, 1e-5);
  EXPECT_LT((closest->normal - Eigen::Vector3d::UnitX()).norm(), 1e-5);
  EXPECT_NEAR(closest->on_a.x(), 0.75, 1e-5);
  EXPECT_NEAR(closest->on_b.x(), 0.5, 1e-5);
}

TEST_F(HullDistance, FromAnEdgeToAnEdge) {
  // Both cubes stand on an edge, crosswise: the closest points are the middles of two edges.
  const double half_diagonal = std::sqrt(0.5);
  const auto closest = closest_points(cube_, at({0.0, 0.0, 2.0}, {0.25 * M_PI, 0.0, 0.0}), cube_,
                                      at({0.0, 0.0, 0.0}, {0.0, 0.25 * M_PI, 0.0}));
  ASSERT_TRUE(closest);
  EXPECT_NEAR(closest->gap_m, 2.0 - 2.0 * half_diagonal, 1e-5);
  EXPECT_LT((closest->on_a - Eigen::Vector3d(0.0, 0.0, 2.0 - half_diagonal)).norm(), 1e-4);
  EXPECT_LT((closest->on_b - Eigen::Vector3d(0.0, 0.0, half_diagonal)).norm(), 1e-4);
}

TEST_F(HullDistance, OverlapIsNegative) {
  const auto closest = closest_points(cube_, at({0.0, 0.9, 0.0}), cube_, at({0.0, 0.0, 0.0}));
  ASSERT_TRUE(closest);
  EXPECT_NEAR(closest->gap_m, -0.1, 1e-6);
  EXPECT_LT((closest->normal - Eigen::Vector3d::UnitY()).norm(), 1e-6);
  EXPECT_LT((closest->on_a - Eigen::Vector3d(0.0, 0.4, 0.0)).norm(), 1e-6) << "the middle of its face";
  EXPECT_LT((closest->on_b - Eigen::Vector3d(0.0, 0.5, 0.0)).norm(), 1e-6);
}

TEST_F(HullDistance, ACornerReachesThroughAFace) {
  // The upper cube stands on a corner, which lies sqrt(0.75) below its centre.
  const Eigen::Quaterniond on_corner = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d(1.0, 1.0, 1.0),  //
                                                                          Eigen::Vector3d(0.0, 0.0, -1.0));
  const double depth_m = 0.05;
  const RigidTransform upper{on_corner, {0.1, -0.2, 0.5 + std::sqrt(0.75) - depth_m}}, lower = at({0.0, 0.0, 0.0});
  const auto closest = closest_points(cube_, upper, cube_, lower), swapped = closest_points(cube_, lower, cube_, upper);
  ASSERT_TRUE(closest && swapped);
  EXPECT_NEAR(closest->gap_m, -depth_m, 1e-6);
  EXPECT_LT((closest->normal - Eigen::Vector3d::UnitZ()).norm(), 1e-6);
  EXPECT_LT((closest->on_a - Eigen::Vector3d(0.1, -0.2, 0.5 - depth_m)).norm(), 1e-6);
  EXPECT_LT((swapped->normal + Eigen::Vector3d::UnitZ()).norm(), 1e-6);
  EXPECT_LT((swapped->on_b - closest->on_a).norm(), 1e-6);
}

TEST_F(HullDistance, IsContinuousThroughContact) {
  for (const double gap_m : {2e-4, 1e-5, -1e-5, -2e-4}) {
    const auto closest = closest_points(cube_, at({0.0, 0.1, 1.0 + gap_m}), cube_, at({0.0, 0.0, 0.0}));
    ASSERT_TRUE(closest);
    EXPECT_NEAR(closest->gap_m, gap_m, 1e-6);
    EXPECT_LT((closest->normal - Eigen::Vector3d::UnitZ()).norm(), 1e-4);
  }
}

TEST_F(HullDistance, IsAsPreciseFarFromTheOrigin) {
  const Eigen::Vector3d far(5e5, -5e6, 100.0);
  const auto closest = closest_points(cube_, at(far + Eigen::Vector3d(0.0, 0.0, 1.001)), cube_, at(far));
  ASSERT_TRUE(closest);
  EXPECT_NEAR(closest->gap_m, 0.001, 1e-6);
  EXPECT_NEAR(closest->on_b.z(), 100.5, 1e-6);
}

}  // namespace
}  // namespace rigidformer
