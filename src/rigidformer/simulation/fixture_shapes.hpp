// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/scene/recording.hpp"
#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// What fixtures and drivers are made of: boxes and upright cylinders of a few proportions, so that the point sets of
/// thousands of slabs are those of some thirty shapes. Their longest edge is 1 m. Names begin with box_ or peg_.
const std::vector<Shape>& fixture_shapes();

/// A convex body as a shape at a size. `rotation` turns the shape's frame to that of the body.
struct Block {
  std::string shape;
  double size = 1.0;
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d edges;  ///< [m] along the axes of the body's frame
};

/// The box whose longest edge is as wished, and the others as near as the proportions allow.
Block block_of(const Eigen::Vector3d& wished_edges);

/// The cylinder about z of that height, and a diameter as near as the proportions allow.
Block peg_of(double wished_diameter, double height);

}  // namespace rigidformer
