// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/enclosed_surface.hpp"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "rigidformer/baselines/cloud_of_shape.hpp"
#include "rigidformer/baselines/engine_scenes.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {
namespace {

TEST(EnclosedSurface, OfASphereIsASphere) {
  const auto surface = enclosed_surface(sphere_cloud(0.5));
  ASSERT_TRUE(surface);
  const MeshVolume measured = measure_volume(*surface);
  EXPECT_NEAR(measured.volume_m3, M_PI / 6.0, 0.02);
  EXPECT_LT(measured.centroid.norm(), 0.005);
}

TEST(EnclosedSurface, ATorusKeepsItsHole) {
  const auto surface = enclosed_surface(cloud_of_shape("torus", 400));
  ASSERT_TRUE(surface);
  const double volume = measure_volume(*surface).volume_m3;
  EXPECT_NEAR(volume, volume_of_shape("torus"), 0.2 * volume_of_shape("torus"));
}

TEST(EnclosedSurface, IsClosed) {
  const auto surface = enclosed_surface(cloud_of_shape("torus", 400));
  ASSERT_TRUE(surface);
  std::map<std::pair<int, int>, int> crossings;  // each edge is walked as often one way as the other
  for (Eigen::Index f = 0; f < surface->triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int from = surface->triangles(f, k), to = surface->triangles(f, (k + 1) % 3);
      crossings[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  for (const auto& [edge, count] : crossings) EXPECT_EQ(count, 0) << edge.first << " - " << edge.second;
}

TEST(EnclosedSurface, HalfASphereEnclosesNothing) {
  const Points sphere = sphere_cloud(0.5, 600);
  EXPECT_FALSE(enclosed_surface(Points(sphere.topRows(300))));  // points are ordered from the top down
}

TEST(EnclosedSurface, RefusesFlatClouds) {
  Points flat = sphere_cloud(0.5, 50);
  flat.col(2).setZero();
  EXPECT_THROW(enclosed_surface(flat), std::invalid_argument);
}

TEST(EnclosedSurface, FewPointsSayNothingAboutDents) {
  EXPECT_FALSE(enclosed_surface(sphere_cloud(0.5, 19)));
  EXPECT_TRUE(enclosed_surface(sphere_cloud(0.5, 20)));
}

}  // namespace
}  // namespace rigidformer
