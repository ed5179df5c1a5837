// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/convex_hull.hpp"

#include <gtest/gtest.h>

namespace rigidformer {
namespace {

TEST(ConvexHull, CubeWithInnerPointsBecomesTwelveOutwardTriangles) {
  Points points(10, 3);
  for (int i = 0; i < 8; ++i) points.row(i) << (i & 1), (i >> 1 & 1), (i >> 2 & 1);
  points.row(8) << 0.5F, 0.5F, 0.5F;
  points.row(9) << 0.2F, 0.7F, 0.4F;
  const ConvexPart hull = convex_hull(points);
  EXPECT_EQ(hull.vertices.rows(), 8);
  ASSERT_EQ(hull.triangles.rows(), 12);
  double volume = 0.0;
  for (int f = 0; f < 12; ++f) {
    const Eigen::Vector3f a = hull.vertices.row(hull.triangles(f, 0));
    const Eigen::Vector3f b = hull.vertices.row(hull.triangles(f, 1));
    const Eigen::Vector3f c = hull.vertices.row(hull.triangles(f, 2));
    volume += a.dot(b.cross(c)) / 6.0;
  }
  EXPECT_NEAR(volume, 1.0, 1e-5);  // positive: the hull is closed and its triangles face outwards
}

TEST(ConvexHull, PointsWithoutVolumeAreRefused) {
  Points flat(5, 3);
  flat << 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 0.5F, 0.5F, 1;
  EXPECT_THROW(convex_hull(flat), std::invalid_argument);
  EXPECT_THROW(convex_hull(flat.topRows(3)), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
