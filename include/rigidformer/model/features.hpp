// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/base_motion.hpp"
#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// Number of features per vertex F: 12 in the paper's form (§3.1).
int64_t num_vertex_features(const ModelOptions& options);

/// Per-vertex inputs of the encoder, [B, K, N, F]; padded vertices are zero.
/// Paper: displacement d to the nearest point of another object or the ground, increment v = x_t - x_{t-1}, offset
/// r = x_t - x_ref, and (mass, friction, restitution). Options of the model replace or extend them.
Tensor vertex_features(const ModelOptions& options, const SceneBatch& batch, const SceneState& state,
                       const BaseMotion& base, const Tensor& points_world, const Nearest& nearest);

}  // namespace rigidformer
