// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Procedural shapes of about the extents of KuBasic's, so that scenes can be made without any file: bone, cone, cube,
/// cylinder, gear, pear, pebble, sphere, sponge, torus, torus_knot (in this order), each centred on its centre of mass.
const std::vector<Shape>& builtin_shapes();

}  // namespace rigidformer
