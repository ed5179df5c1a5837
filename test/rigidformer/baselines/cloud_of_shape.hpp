// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "rigidformer/scene/surface_sampling.hpp"
#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {

inline const Shape& builtin_shape(const std::string& name) {
  for (const Shape& shape : builtin_shapes()) {
    if (shape.name == name) return shape;
  }
  throw std::invalid_argument("no shape named " + name);
}

/// Random points on the surface of a built-in shape.
inline Points cloud_of_shape(const std::string& name, int count) {
  return sample_surface(builtin_shape(name), count, 7).points;
}

/// Volume of a built-in shape [m^3], summed over its parts, which hardly overlap.
inline double volume_of_shape(const std::string& name) { return measure_volume(builtin_shape(name).parts).volume_m3; }

}  // namespace rigidformer
