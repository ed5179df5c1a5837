// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/windows/scene_tensors.hpp"

namespace rigidformer {

/// The commands [B, C] of every step of windows whose frames are `frame` [B, T] int64 into flattened (scene, frame): a
/// step has the command of the frame that it begins at, the second one for the first step. Directions in them turn with
/// the scenes by yaw [B, 3, 3]. Empty where nothing is commanded.
std::vector<Tensor> window_commands(const SceneTensors& tensors, const Tensor& frame, const Tensor& yaw);

}  // namespace rigidformer
