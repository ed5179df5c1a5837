// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/baselines/observed_body.hpp"

namespace rigidformer {

/// Writes the bodies, one hull each, above a floor plane z = 0 as a MuJoCo model in XML. Body i has the
/// joint coordinates 7 i ... 7 i + 6.
std::string mujoco_scene(const std::vector<ObservedBody>& bodies, double gravity, double solver_step_s);

}  // namespace rigidformer
