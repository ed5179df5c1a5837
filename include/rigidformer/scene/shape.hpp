// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// One closed convex triangle mesh in the shape's frame at size 1.
struct ConvexPart {
  Points vertices;                                                   ///< [V, 3] corners [m]
  Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> triangles;  ///< [F, 3] indices into vertices
};

/// A rigid shape as the union of convex parts. Its origin is its centre of mass.
struct Shape {
  std::string name;
  double mass_kg = 1.0;  ///< Mass at size 1 and density factor 1
  std::vector<ConvexPart> parts;

  /// All vertices of all parts [V, 3] at size 1: the points that mesh-based methods use.
  Points vertices() const;

  /// Longest edge of the axis-parallel box around all parts [m], size 1; 0 without vertices.
  double largest_extent() const;
};

}  // namespace rigidformer
