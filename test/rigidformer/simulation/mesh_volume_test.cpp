// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/mesh_volume.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace rigidformer
