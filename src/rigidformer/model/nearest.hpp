// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"

namespace rigidformer {

/// Finds nearest points by the full distance matrix, for training on a GPU and as a reference for tests. One
/// matrix product per chunk ranks |y|^2 - 2 x.y. An indicator per object, appended to the coordinates,
/// pushes an object's own points away.
Nearest nearest_by_distance_matrix(const SceneBatch& batch, const Pose& current, const Tensor& points_world);

}  // namespace rigidformer
