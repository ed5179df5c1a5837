// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Convex parts that together come closer to the object than one hull does: the enclosed surface of the cloud (see
/// enclosed_surface.hpp), cut by HACD. It is one hull when nothing is enclosed, or when the surface fills nine tenths
/// of its hull. Throws std::invalid_argument for what enclosed_surface() refuses.
std::vector<ConvexPart> convex_parts(const Points& points);

}  // namespace rigidformer
