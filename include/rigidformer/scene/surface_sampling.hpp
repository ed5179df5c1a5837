// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Points on the outer surface of a shape with outward unit normals, both [N, 3].
struct SurfaceSamples {
  Points points;
  Points normals;
};

/// Draws `count` points uniformly by area on the outer surface at size 1. Points inside another convex part are
/// rejected. The same seed gives the same points. Throws std::invalid_argument for a shape without area.
SurfaceSamples sample_surface(const Shape& shape, int count, std::uint64_t seed);

/// Gives all mesh vertices, each with the area-weighted mean normal of the triangles around it.
SurfaceSamples vertices_with_normals(const Shape& shape);

}  // namespace rigidformer
