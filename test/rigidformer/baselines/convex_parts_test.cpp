// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/convex_parts.hpp"

#include <gtest/gtest.h>

#include "rigidformer/baselines/cloud_of_shape.hpp"
#include "rigidformer/baselines/engine_scenes.hpp"
#include "rigidformer/simulation/convex_hull.hpp"

namespace rigidformer {
namespace {

TEST(ConvexParts, ConvexObjectsAreOneHull) {
  EXPECT_EQ(convex_parts(sphere_cloud(0.5)).size(), 1U);
  EXPECT_EQ(convex_parts(box_cloud({1.0, 0.5, 0.5})).size(), 1U);
}

TEST(ConvexParts, ATorusIsCutIntoPartsThatLeaveItsHoleFree) {
  const Points cloud = cloud_of_shape("torus", 400);
  const auto parts = convex_parts(cloud);
  EXPECT_GE(parts.size(), 4U);
  const double truth = volume_of_shape("torus");
  const double hull = measure_volume(convex_hull(cloud)).volume_m3;
  EXPECT_LT(measure_volume(parts).volume_m3 - truth, 0.5 * (hull - truth));
  EXPECT_GT(measure_volume(parts).volume_m3, 0.8 * truth);
}

TEST(ConvexParts, OneViewIsOneHull) {
  const Points sphere = sphere_cloud(0.5, 600);
  EXPECT_EQ(convex_parts(Points(sphere.topRows(300))).size(), 1U);
}

}  // namespace
}  // namespace rigidformer
