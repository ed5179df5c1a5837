// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/observed_hull.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rigidformer {
namespace {

const Eigen::Vector3d kCentre(0.5, -0.2, 0.1);

/// Points of those faces of a unit cube around kCentre whose outward normals `keep` accepts.
template <typename Keep>
Points cube_faces(Keep&& keep) {
  std::vector<Eigen::Vector3f> points;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-0.5F, 0.5F}) {
      if (!keep(axis, side)) continue;
      for (int i = 0; i <= 4; ++i) {
        for (int j = 0; j <= 4; ++j) {
          Eigen::Vector3f p = kCentre.cast<float>();
          p[axis] += side;
          p[(axis + 1) % 3] += 0.25F * static_cast<float>(i) - 0.5F;
          p[(axis + 2) % 3] += 0.25F * static_cast<float>(j) - 0.5F;
          points.push_back(p);
        }
      }
    }
  }
  Points cloud(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) cloud.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return cloud;
}

TEST(ObservedHull, OfACompleteCloudIsItsHullAroundTheCentreOfMass) {
  const ObservedHull observed = observe_hull(cube_faces([](int, float) { return true; }), kCentre);
  EXPECT_TRUE(observed.complete);
  EXPECT_NEAR(observed.volume_m3, 1.0, 1e-5);
  EXPECT_NEAR(observed.hull.vertices.maxCoeff(), 0.5, 1e-6);
  EXPECT_NEAR(observed.hull.vertices.minCoeff(), -0.5, 1e-6);
}

TEST(ObservedHull, TheCentreOfACompleteHullCorrectsTheEstimate) {
  const Eigen::Vector3d estimate = kCentre + Eigen::Vector3d(0.03, 0.0, -0.02);
  const ObservedHull observed = observe_hull(cube_faces([](int, float) { return true; }), estimate);
  EXPECT_LT((observed.centre_of_mass - kCentre).norm(), 1e-6);
  EXPECT_NEAR(observed.hull.vertices.maxCoeff(), 0.5, 1e-6);
}

TEST(ObservedHull, OneSideIsCompletedThroughTheCentreOfMass) {
  const auto seen = [](int axis, float side) { return axis != 0 && side > 0.0F; };
  const ObservedHull observed = observe_hull(cube_faces(seen), kCentre);
  EXPECT_FALSE(observed.complete);
  EXPECT_EQ(observed.centre_of_mass, kCentre);
  EXPECT_NEAR(observed.volume_m3, 1.0, 1e-5);
  EXPECT_NEAR(observed.hull.vertices.minCoeff(), -0.5, 1e-6);
}

TEST(ObservedHull, GuessedPointsStandForTheOtherSideInsteadOfMirrorImages) {
  const auto top = [](int axis, float side) { return axis == 2 && side > 0.0F; };
  Points tip(1, 3);
  tip << kCentre.cast<float>().transpose() - Eigen::RowVector3f(0.0F, 0.0F, 1.0F);
  const ObservedHull pyramid = observe_hull(cube_faces(top), kCentre, tip);
  EXPECT_NEAR(pyramid.volume_m3, 1.5 / 3.0, 0.02);
  EXPECT_NEAR(pyramid.hull.vertices.col(2).minCoeff(), -1.0, 1e-6);
}

TEST(ObservedHull, GuessedPointsDoNotTouchACompleteCloud) {
  Points far(1, 3);
  far << kCentre.cast<float>().transpose() + Eigen::RowVector3f(5.0F, 0.0F, 0.0F);
  EXPECT_NEAR(observe_hull(cube_faces([](int, float) { return true; }), kCentre, far).volume_m3, 1.0, 1e-5);
}

TEST(ObservedHull, OneFaceIsEnough) {
  const ObservedHull observed =
      observe_hull(cube_faces([](int axis, float side) { return axis == 2 && side > 0.0F; }), kCentre);
  EXPECT_NEAR(observed.volume_m3, 1.0, 0.02);  // the face and its image, each a centimetre thick
}

TEST(ObservedHull, FewPointsMakeASmallSolid) {
  const Points one = kCentre.cast<float>().transpose();
  EXPECT_NEAR(observe_hull(one, kCentre).volume_m3, 1e-6, 1e-7);  // a cube of one centimetre
}

}  // namespace
}  // namespace rigidformer
