// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/standing_hull.hpp"

#include <gtest/gtest.h>

#include "rigidformer/simulation/convex_hull.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {
namespace {

/// A box of these edges about its centre of mass.
ObservedSolid box_solid(const Eigen::Vector3d& edges_m, std::int64_t object = 0) {
  Points corners(8, 3);
  for (int i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      corners(i, axis) = static_cast<float>(edges_m[axis] * ((i >> axis & 1) != 0 ? 0.5 : -0.5));
    }
  }
  ObservedSolid solid;
  solid.object = object;
  solid.centre_reference.setZero();
  const ConvexPart hull = convex_hull(corners);
  return with_hull(solid, hull, measure_volume(hull).volume_m3, {});
}

RigidTransform lifted(double z) { return {Eigen::Quaterniond::Identity(), {0.0, 0.0, z}}; }

ObservedSolid standing(const ObservedSolid& solid, const RigidTransform& T_world_body) {
  return on_their_feet(SolidScene({solid}, 0.0), {T_world_body}, {true}, {BodyProperties()})[0];
}

/// The least distance of the centre of mass, seen from above, from the end of the lowest points.
double margin_m(const ObservedSolid& solid, const Eigen::Quaterniond& rotation) {
  const Points points = RigidTransform{rotation, Eigen::Vector3d::Zero()}.apply(solid.hull->vertices);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 64; ++i) {
    const Eigen::Vector2f d(std::cos(0.1F * static_cast<float>(i)), std::sin(0.1F * static_cast<float>(i)));
    float farthest = -1e9F;
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
      if (points(row, 2) < points.col(2).minCoeff() + 0.01F) {
        farthest = std::max(farthest, points.row(row).head<2>().dot(d.transpose()));
      }
    }
    least = std::min(least, static_cast<double>(farthest));
  }
  return least;
}

TEST(StandingHull, ASheetGetsAFootUnderItsCentreOfMass) {
  const ObservedSolid sheet = box_solid({0.01, 0.6, 1.0}), stands = standing(sheet, lifted(0.5));
  EXPECT_LT(margin_m(sheet, Eigen::Quaterniond::Identity()), 0.006);
  EXPECT_GT(margin_m(stands, Eigen::Quaterniond::Identity()), 0.045) << "a tenth of the height of its centre";
  EXPECT_NEAR(stands.hull->vertices.col(2).minCoeff(), -0.5, 1e-6) << "it stands where it stood";
  EXPECT_NEAR(stands.hull->vertices.col(2).maxCoeff(), 0.5, 1e-6);
}

TEST(StandingHull, ReachesDownToWhatIsBelow) {
  EXPECT_NEAR(standing(box_solid({0.01, 0.6, 1.0}), lifted(0.55)).hull->vertices.col(2).minCoeff(), -0.55, 1e-6);
  const ObservedSolid shelf = box_solid({1.0, 1.0, 1.0}, 1);
  const auto both = on_their_feet(SolidScene({box_solid({0.3, 0.6, 1.0}), shelf}, 0.0), {lifted(2.04), lifted(1.0)},
                                  {true, false}, {{}, {}});
  EXPECT_NEAR(both[0].hull->vertices.col(2).minCoeff(), -0.54, 2e-3);
  EXPECT_EQ(both[1].hull, shelf.hull) << "nobody said that the shelf stands";
}

TEST(StandingHull, DoesNotReachForWhatIsFarBelow) {
  EXPECT_NEAR(standing(box_solid({0.01, 0.6, 1.0}), lifted(2.0)).hull->vertices.col(2).minCoeff(), -0.5, 1e-6);
}

TEST(StandingHull, WhatCanStandKeepsItsHull) {
  const ObservedSolid solid = box_solid({0.5, 0.6, 1.0});
  EXPECT_EQ(standing(solid, lifted(0.5)).hull, solid.hull);
}

TEST(StandingHull, StandsInAnyFrame) {
  const Eigen::Quaterniond R(Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitX()));
  const ObservedSolid lying = standing(box_solid({0.01, 1.0, 0.6}), {R, Eigen::Vector3d(3.0, 2.0, 0.5)});
  EXPECT_GT(margin_m(lying, R), 0.045);
}

TEST(StandingHull, KeepsWhatWasSeen) {
  const ObservedSolid sheet = box_solid({0.01, 0.6, 1.0}), stands = standing(sheet, lifted(0.55));
  const SolidHull hull(*stands.hull);
  for (Eigen::Index i = 0; i < sheet.hull->vertices.rows(); ++i) {
    const Eigen::Vector3d point = sheet.hull->vertices.row(i).cast<double>().transpose();
    EXPECT_LT((hull.normals().transpose() * point - hull.offsets()).maxCoeff(), 1e-5);
  }
  EXPECT_GT(stands.volume_m3, sheet.volume_m3);
}

}  // namespace
}  // namespace rigidformer
