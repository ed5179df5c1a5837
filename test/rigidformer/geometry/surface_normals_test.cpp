// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/surface_normals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "rigidformer/geometry/farthest_point_sampling.hpp"
#include "rigidformer/geometry/random.hpp"

namespace rigidformer {
namespace {

Points in_farthest_point_order(const Points& points) {
  return points(farthest_point_order(points, static_cast<int>(points.rows())), Eigen::all);
}

Points drawn(int count, const std::function<Eigen::Vector3f(Random&)>& draw) {
  Random random(3);
  Points points(count, 3);
  for (int i = 0; i < count; ++i) points.row(i) = draw(random).transpose();
  return in_farthest_point_order(points);
}

Points sphere(int count) {
  return drawn(count, [](Random& random) {
    const double z = random.uniform(-1.0, 1.0), angle = random.uniform(0.0, 2.0 * M_PI), r = std::sqrt(1.0 - z * z);
    return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z).cast<float>().eval();
  });
}

/// On the surface of the cube of size 2.
Points cube(int count) {
  return drawn(count, [](Random& random) {
    Eigen::Vector3d p(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    p[static_cast<int>(random.uniform(0.0, 3.0))] = random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
    return p.cast<float>().eval();
  });
}

constexpr double kRing = 1.0, kTube = 0.4;  // radii of the torus

Points torus(int count) {
  return drawn(count, [](Random& random) {
    const double u = random.uniform(0.0, 2.0 * M_PI), v = random.uniform(0.0, 2.0 * M_PI);
    const double r = kRing + kTube * std::cos(v);
    return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), kTube * std::sin(v)).cast<float>().eval();
  });
}

/// Share of the rows whose angle to the true normal is at most `degrees`.
double share_within(const Points& normals, const Points& truth, double degrees) {
  return ((normals.cwiseProduct(truth)).rowwise().sum().array() >= std::cos(degrees * M_PI / 180.0))
      .cast<double>()
      .mean();
}

TEST(SurfaceNormals, OfTheCornersOfACubeAreItsDiagonals) {
  Points corners(8, 3);
  for (int i = 0; i < 8; ++i) corners.row(i) << (i & 1 ? 1.0F : -1.0F), (i & 2 ? 1.0F : -1.0F), (i & 4 ? 1.0F : -1.0F);
  corners = in_farthest_point_order(corners);
  EXPECT_GT(share_within(estimate_normals(corners), corners / std::sqrt(3.0F), 1.0), 0.999);
}

TEST(SurfaceNormals, OfFacesAreThoseOfTheFacesUpToTheEdges) {
  const Points points = cube(256);
  Points truth = Points::Zero(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Eigen::Index axis = 0;
    points.row(i).cwiseAbs().maxCoeff(&axis);
    truth(i, axis) = points(i, axis);
  }
  EXPECT_GT(share_within(estimate_normals(points), truth, 5.0), 0.7);
  EXPECT_GT(share_within(estimate_normals(points), truth, 90.0), 0.999);
}

TEST(SurfaceNormals, OfASpherePointAwayFromItsCentre) {
  const Points points = sphere(128);
  EXPECT_GT(share_within(estimate_normals(points), points, 35.0), 0.999);
  EXPECT_GT(share_within(estimate_normals(points), points, 20.0), 0.7);
}

TEST(SurfaceNormals, MostlyPointIntoTheHoleOfARing) {
  const Points points = torus(1000);  // the first 256 in farthest-point order are spread evenly
  Points truth(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Eigen::RowVector3f ring(points(i, 0), points(i, 1), 0.0F);
    truth.row(i) = (points.row(i) - static_cast<float>(kRing) * ring.normalized()) / static_cast<float>(kTube);
  }
  const Points normals = estimate_normals(points);
  EXPECT_GT(share_within(normals, truth, 90.0), 0.85);
  const double within_or_opposite = share_within(normals, truth, 30.0) + share_within(-normals, truth, 30.0);
  EXPECT_GT(within_or_opposite, 0.7);
}

TEST(SurfaceNormals, TurnWithTheCloudAndDoNotChangeWithItsSize) {
  const Points points = cube(100);
  const RigidTransform T{Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized())),
                         Eigen::Vector3d(3.0, -1.0, 0.25)};
  const RigidTransform turn{T.rotation, Eigen::Vector3d::Zero()};
  const Points expected = turn.apply(estimate_normals(points));
  EXPECT_LT((estimate_normals(T.apply(0.1F * points)) - expected).cwiseAbs().maxCoeff(), 1e-2);
}

TEST(SurfaceNormals, AreUnitVectorsWhateverTheCloud) {
  Points same = Points::Ones(6, 3), line = Points::Zero(6, 3), plane = Points::Random(9, 3);
  line.col(0).setLinSpaced(0.0F, 5.0F);
  plane.col(2).setZero();
  for (const Points& points : {same, line, plane, Points(Points::Zero(1, 3)), cube(700)}) {
    const Points normals = estimate_normals(points);
    ASSERT_EQ(normals.rows(), points.rows());
    EXPECT_LT((normals.rowwise().norm().array() - 1.0F).abs().maxCoeff(), 1e-5);
  }
}

}  // namespace
}  // namespace rigidformer
