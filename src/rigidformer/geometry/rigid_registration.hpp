// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// Least-squares rigid motion T_target_source between two clouds [N, 3] whose rows correspond (Kabsch's method, without
/// scale). Throws std::invalid_argument for different sizes, fewer than 3 points or coordinates that are not finite.
RigidTransform fit_rigid_transform(const Points& source, const Points& target);

/// Distance [m] of each row of `target` [N, 3] from the moved row of `source` [N, 3].
Eigen::VectorXd registration_residuals(const RigidTransform& T_target_source, const Points& source,
                                       const Points& target);

}  // namespace rigidformer
