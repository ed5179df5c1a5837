// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/tracking/pose_history.hpp"

namespace rigidformer {

/// How long an object was seen not to move up to its newest pose, as well as poses with this noise [m] can tell.
/// `points_object` is its cloud; `before` was seen of it up to the first of the poses, and counts where it has not
/// moved since.
Stillness seen_still(const PoseHistory& poses, const Points& points_object, const Stillness& before, double noise_m);

}  // namespace rigidformer
