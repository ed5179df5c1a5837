// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// Indices of the rows of `points` that are finite.
std::vector<int> finite_rows(const Points& points);

/// Selects rows of `points`.
Points select_rows(const Points& points, const std::vector<int>& rows);

}  // namespace rigidformer
