// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer_ros {

/// Throws std::invalid_argument when a cloud [N, 3] m in the fixed frame lies so far from the origin that single
/// precision no longer resolves millimetres, as in a frame of UTM coordinates. The text has the place and the remedy.
void require_near_origin(const rigidformer::Points& points_world, const std::string& fixed_frame);

}  // namespace rigidformer_ros
