// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// A triangle mesh that need not be convex.
using TriangleMesh = ConvexPart;

/// The closed surface that a complete cloud suggests, with triangles that face outwards. Space is cut into the Delaunay
/// tetrahedra of the points. What can be reached from outside through gaps wider than the spacing of the points is air,
/// and the rest is solid. The answer is empty for fewer than 20 points and when (nearly) nothing is solid, as for
/// clouds of one view. Throws std::invalid_argument for points in one plane.
std::optional<TriangleMesh> enclosed_surface(const Points& points);

}  // namespace rigidformer
