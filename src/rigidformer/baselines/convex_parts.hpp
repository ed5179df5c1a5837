// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Convex parts that together come closer to the object than one hull: the enclosed surface of the cloud (see
/// enclosed_surface.hpp), cut by HACD. One hull when nothing is enclosed or the surface is convex but for a tenth of
/// its volume. Throws std::invalid_argument as enclosed_surface does.
std::vector<ConvexPart> convex_parts(const Points& points);

}  // namespace rigidformer
