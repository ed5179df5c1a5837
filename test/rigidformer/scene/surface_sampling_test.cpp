// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/scene/surface_sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigidformer {
namespace {

/// An axis-aligned box from `low` to `high`, triangles facing outwards.
ConvexPart box(const Eigen::RowVector3f& low, const Eigen::RowVector3f& high) {
  ConvexPart part;
  part.vertices.resize(8, 3);
  for (int i = 0; i < 8; ++i) {
    part.vertices.row(i) << ((i & 1) != 0 ? high : low)[0], ((i & 2) != 0 ? high : low)[1],
        ((i & 4) != 0 ? high : low)[2];
  }
  part.triangles.resize(12, 3);
  part.triangles << 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7,
      4, 7, 6;
  return part;
}

const Shape kBox{"box", 1.0, {box({-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F})}};

TEST(SurfaceSampling, PointsLieOnTheSurfaceWithOutwardUnitNormals) {
  const SurfaceSamples samples = sample_surface(kBox, 500, 1);
  ASSERT_EQ(samples.points.rows(), 500);
  ASSERT_EQ(samples.normals.rows(), 500);
  for (int i = 0; i < 500; ++i) {
    EXPECT_NEAR(samples.points.row(i).cwiseAbs().maxCoeff(), 0.5F, 1e-6);
    EXPECT_NEAR(samples.normals.row(i).norm(), 1.0F, 1e-6);
    EXPECT_NEAR(samples.points.row(i).dot(samples.normals.row(i)), 0.5F, 1e-6);
  }
}

TEST(SurfaceSampling, IsUniformByArea) {
  const Shape slab{"slab", 1.0, {box({0, 0, 0}, {4, 1, 1})}};
  const SurfaceSamples samples = sample_surface(slab, 6000, 2);
  const auto ends = (samples.normals.col(0).array().abs() > 0.5F).count();
  EXPECT_NEAR(static_cast<double>(ends) / 6000.0, 2.0 / 18.0, 0.015);  // about 3.5 standard deviations
  EXPECT_NEAR(samples.points.col(0).mean(), 2.0F, 0.07F);
}

TEST(SurfaceSampling, PointsInsideAnotherPartAndOnSharedFacesAreRejected) {
  const Shape overlapping{"overlapping", 1.0, {box({0, 0, 0}, {1, 1, 1}), box({0.5F, 0.2F, 0.2F}, {2, 0.8F, 0.8F})}};
  const SurfaceSamples samples = sample_surface(overlapping, 2000, 3);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Array3f p = samples.points.row(i).transpose();
    EXPECT_FALSE((p > 0.001F).all() && (p < 0.999F).all()) << p.transpose();
    const bool in_rod = p.x() > 0.501F && (p.tail<2>() > 0.201F).all() && (p.tail<2>() < 0.799F).all();
    EXPECT_FALSE(in_rod && p.x() < 1.999F) << p.transpose();
  }
  const Shape touching{"touching", 1.0, {box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})}};
  EXPECT_EQ((sample_surface(touching, 1000, 4).points.col(0).array() == 1.0F).count(), 0);
}

TEST(SurfaceSampling, TheSeedDecides) {
  EXPECT_EQ(sample_surface(kBox, 50, 5).points, sample_surface(kBox, 50, 5).points);
  EXPECT_NE(sample_surface(kBox, 50, 5).points, sample_surface(kBox, 50, 6).points);
}

TEST(SurfaceSampling, ShapesWithoutAreaAreRefused) {
  EXPECT_THROW(sample_surface(Shape{"empty", 1.0, {}}, 10, 0), std::invalid_argument);
  EXPECT_THROW(sample_surface(Shape{"flat", 1.0, {box({0, 0, 0}, {0, 0, 1})}}, 10, 0), std::invalid_argument);
  EXPECT_THROW(sample_surface(kBox, -1, 0), std::invalid_argument);
  EXPECT_EQ(sample_surface(kBox, 0, 0).points.rows(), 0);
}

TEST(SurfaceSampling, NormalsOfVerticesPointAwayFromTheSolid) {
  const SurfaceSamples corners = vertices_with_normals(kBox);
  ASSERT_EQ(corners.points.rows(), 8);
  for (Eigen::Index i = 0; i < 8; ++i) {
    EXPECT_NEAR(corners.normals.row(i).norm(), 1.0F, 1e-5F);
    EXPECT_GT(corners.normals.row(i).dot(corners.points.row(i)), 0.0F);
  }
}

TEST(Shape, VerticesOfAllPartsInOrder) {
  const Shape shape{"two", 1.0, {box({0, 0, 0}, {1, 1, 1}), box({2, 2, 2}, {3, 3, 3})}};
  const Points vertices = shape.vertices();
  ASSERT_EQ(vertices.rows(), 16);
  EXPECT_EQ(vertices.topRows(8), shape.parts[0].vertices);
  EXPECT_EQ(vertices.bottomRows(8), shape.parts[1].vertices);
}

}  // namespace
}  // namespace rigidformer
