// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/simulation/mujoco_world.hpp"

namespace rigidformer {

/// Writes the bodies above a floor plane z = 0 as a MuJoCo model in XML, body i with the id i + 1. All but the static
/// ones have a free joint. Geoms touch only in the pairs that are listed; what nothing can push (static or on a path)
/// is in none with the floor or its like.
std::string mujoco_scene(const std::vector<MujocoBody>& bodies, const MujocoSettings& settings);

}  // namespace rigidformer
