// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// Outward unit normals [N, 3] of points of a surface, estimated from the points alone, so that sparse mesh vertices,
/// samples of a surface and clouds of a sensor are treated alike. `points` are in farthest-point order: the first 256
/// serve as neighbours of all, which keeps the neighbourhoods as large for dense clouds as for thin ones.
/// Which side is out follows from where the other points are: right for convex bodies, mostly so around holes, and
/// not to be told for a cloud of one flat side.
Points estimate_normals(const Points& points);

}  // namespace rigidformer
