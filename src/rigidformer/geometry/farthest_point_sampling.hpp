// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// Greedy farthest point sampling: returns `count` (at most N) row indices of `points`, in the order in which they were
/// chosen. The first is the point farthest from the centroid, so that the result depends neither on the order of the
/// points (but for ties) nor on the frame.
std::vector<int> farthest_point_order(const Points& points, int count);

}  // namespace rigidformer
