// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/simulation/mujoco_world.hpp"

namespace rigidformer {

/// Writes the bodies above a floor plane z = 0 as a MuJoCo model in XML. Body i has the joint coordinates
/// 7 i ... 7 i + 6. Geoms touch only in the pairs that are listed.
std::string mujoco_scene(const std::vector<MujocoBody>& bodies, const MujocoSettings& settings);

}  // namespace rigidformer
