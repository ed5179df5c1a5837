// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"

namespace rigidformer {

/// Where objects whose motion is given (static, driven) are at t + 1: SceneState::coming, or without it where the twist
/// between their two poses takes them. Everything that looks ahead (base motion, features, engine, search for
/// contacts) and the step itself ask here, so that they agree. Rows of dynamic objects have no meaning.
Pose coming_pose(const SceneState& state);

}  // namespace rigidformer
