// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/surface_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/tracking/reference_cloud.hpp"

namespace rigidformer {
namespace {

constexpr int kSide = 11;         // points along an edge
constexpr float kSpacing = 0.1F;  // [m]
constexpr double kNoise = 0.003;  // [m] the default of correspondence/noise

// A square of 1 m in the plane z = 0, with one corner at the origin.
Points square() {
  Points points = Points::Zero(kSide * kSide, 3);
  for (int i = 0; i < kSide * kSide; ++i) {
    points(i, 0) = kSpacing * static_cast<float>(i % kSide);
    points(i, 1) = kSpacing * static_cast<float>(i / kSide);
  }
  return points;
}

// The square and another one in the plane x = 1, which share the edge between them.
Points two_faces() {
  Points points(2 * kSide * kSide - kSide, 3);
  points.topRows(kSide * kSide) = square();
  for (int i = 0; i < kSide * (kSide - 1); ++i) {
    points.row(kSide * kSide + i) << 1.0F, kSpacing * static_cast<float>(i % kSide),
        -kSpacing * static_cast<float>(1 + i / kSide);
  }
  return points;
}

TEST(SurfaceCloud, PointsBesideAnEdgeHaveTheNormalOfTheirFace) {
  const SurfaceCloud cloud = estimate_surface(two_faces(), kNoise);
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    const Eigen::RowVector3f point = cloud.points.row(i);
    if (point.z() < 0.0F) {
      EXPECT_GT(std::abs(cloud.normals(i, 0)), 0.99F) << point;
    } else if (point.x() < 1.0F) {
      EXPECT_GT(std::abs(cloud.normals(i, 2)), 0.99F) << point;
    }
  }
}

TEST(SurfaceCloud, TooFewPointsHaveNoNormals) {
  EXPECT_TRUE(estimate_surface(square().topRows(8), kNoise).normals.isZero());
}

TEST(FindBorder, PointOutwardAllAroundAFlatFace) {
  const SurfaceCloud cloud = estimate_surface(square(), kNoise);
  const PointTree tree(cloud.points);
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    const Eigen::RowVector3f from_middle = cloud.points.row(i) - Eigen::RowVector3f(0.5F, 0.5F, 0.0F);
    const Eigen::Vector3f border = find_border(tree, cloud.normals, i, 1.4);
    if (from_middle.cwiseAbs().maxCoeff() < 0.35F) {
      EXPECT_TRUE(border.isZero()) << cloud.points.row(i);
    } else if (from_middle.cwiseAbs().maxCoeff() > 0.45F) {
      EXPECT_GT(border.dot(from_middle.normalized().transpose()), 0.7F) << cloud.points.row(i);
    }
  }
}

TEST(FindBorder, ABallHasNoneWhereItTurnsOutOfView) {
  Points cap(400, 3);
  for (int i = 0; i < 400; ++i) {
    const float height = 1.0F - static_cast<float>(i) / 400.0F;
    const float angle = 2.4F * static_cast<float>(i);  // the golden angle spreads points evenly
    const float radius = std::sqrt(1.0F - height * height);
    cap.row(i) << radius * std::cos(angle), radius * std::sin(angle), height;
  }
  const SurfaceCloud cloud = estimate_surface(cap, kNoise);
  const PointTree tree(cloud.points);
  for (Eigen::Index i = 0; i < cap.rows(); ++i) {
    EXPECT_TRUE(find_border(tree, cloud.normals, i, 2.0).isZero()) << cap.row(i);
  }
}

TEST(ReferenceCloud, FindsTheNearestPointOfTheSameFace) {
  const ReferenceCloud reference(estimate_surface(two_faces(), kNoise), CorrespondenceOptions());
  const Eigen::Vector3f beside_edge(0.97F, 0.5F, -0.03F);
  for (const int axis : {0, 2}) {
    const int row = reference.nearest(beside_edge, Eigen::Vector3f::Unit(axis));
    EXPECT_GT(std::abs(reference.normals()(row, axis)), 0.9F) << "axis " << axis;
  }
}

}  // namespace
}  // namespace rigidformer
