// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Convex hull of `points` [N, 3] as triangles that face outwards; points inside the hull are dropped.
/// Throws std::invalid_argument for fewer than 4 points or points in one plane.
ConvexPart convex_hull(const Points& points);

}  // namespace rigidformer
