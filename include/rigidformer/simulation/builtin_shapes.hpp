// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Procedural shapes of about the extents of KuBasic's, so that scenes can be made without any file: bone, cone, cube,
/// cylinder, gear, pear, pebble, sphere, sponge, torus, torus_knot (in this order), each centred on its centre of mass.
const std::vector<Shape>& builtin_shapes();

/// Which rotations of a shape nobody can see.
enum class Symmetry {
  kNone,
  kAxis,  ///< A body of revolution: those about its z axis
  kAll    ///< A sphere: every one
};

/// Symmetry of the built-in shape of that name, which KuBasic's of the same name has as well; kNone for other names. A
/// gear has teeth, by which its turning is seen.
Symmetry symmetry_of(const std::string& shape);

/// Angle between two orientations of a shape [rad] as far as it can be seen.
double visible_angle(const std::string& shape, const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

}  // namespace rigidformer
