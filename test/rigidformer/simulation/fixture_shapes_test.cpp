// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/fixture_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "rigidformer/simulation/mesh_volume.hpp"
#include "rigidformer/simulation/scene_recorder.hpp"

namespace rigidformer {
namespace {

TEST(FixtureShapes, AreClosedConvexBodiesAboutTheirCentre) {
  std::set<std::string> names;
  for (const Shape& shape : fixture_shapes()) {
    SCOPED_TRACE(shape.name);
    EXPECT_TRUE(names.insert(shape.name).second);
    ASSERT_EQ(shape.parts.size(), 1U);
    EXPECT_NEAR(shape.largest_extent(), 1.0, 1e-6);
    const MeshVolume measured = measure_volume(shape.parts);
    EXPECT_LT(measured.centroid.norm(), 1e-6);
    EXPECT_NEAR(measured.volume_m3, shape.mass_kg, 0.03 * shape.mass_kg);  // a peg has 16 sides
    EXPECT_GE(shape.parts[0].vertices.rows(), 16) << "vertices stand for the faces";
  }
}

TEST(FixtureShapes, ABlockLiesAsItsEdgesSay) {
  for (const Eigen::Vector3d& wished : {Eigen::Vector3d(3.0, 2.2, 0.1), Eigen::Vector3d(0.2, 1.5, 0.8),
                                        Eigen::Vector3d(0.3, 0.3, 0.9), Eigen::Vector3d(1.0, 0.07, 2.0)}) {
    const Block block = block_of(wished);
    const Points corners = RigidTransform{block.rotation, Eigen::Vector3d::Zero()}.apply(
        static_cast<float>(block.size) * find_shape(fixture_shapes(), block.shape).vertices());
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(corners.col(axis).maxCoeff() - corners.col(axis).minCoeff(), block.edges[axis], 1e-5);
      EXPECT_LT(std::abs(std::log(block.edges[axis] / wished[axis])), 0.5);
    }
    EXPECT_DOUBLE_EQ(block.edges.maxCoeff(), wished.maxCoeff());
  }
}

TEST(FixtureShapes, APegHasItsHeight) {
  const Block peg = peg_of(0.3, 1.5);
  EXPECT_DOUBLE_EQ(peg.edges.z(), 1.5);
  EXPECT_NEAR(peg.edges.x(), 0.3, 0.05);
}

}  // namespace
}  // namespace rigidformer
