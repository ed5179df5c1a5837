// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Convex hull of `points` [N, 3] as triangles that face outwards; points inside the hull are dropped.
/// Throws std::invalid_argument for fewer than 4 points or points in one plane.
ConvexPart convex_hull(const Points& points);

/// Gives points that span a volume: clouds thinner than 1 cm along a principal axis (one face, a line) are doubled and
/// moved half a centimetre to each side.
Points with_thickness(Points points);

}  // namespace rigidformer
