// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// Greedy farthest point sampling. Returns `count` (at most N) row indices of `points`, in the order chosen. The first
/// is the point farthest from the centroid, so the result does not depend on the order of the points (ties aside) or on
/// the frame.
std::vector<int> farthest_point_order(const Points& points, int count);

}  // namespace rigidformer
