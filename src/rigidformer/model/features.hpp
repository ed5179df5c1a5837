// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/base_motion.hpp"
#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// Number of features per vertex F: 12 in the paper's form (§3.1).
std::int64_t num_vertex_features(const ModelOptions& options);

/// Number of features per point about the engine's step; 0 without it.
std::int64_t num_engine_features(const ModelOptions& options);

/// Number of features about the ground, which the points of all objects share; 0 without them. They come last wherever
/// they are read, so that the weights of a model without them fit.
std::int64_t num_ground_features(const ModelOptions& options);

/// Material of the ground for every point [B, K, count, num_ground_features].
Tensor ground_features(const ModelOptions& options, const SceneBatch& batch, std::int64_t count);

/// How the engine's step differs from the base motion at points [B, K, *, 3] of the reference frame, by the change of
/// velocity over the step and of the one at its end: [B, K, *, 6].
Tensor engine_features(const SceneBatch& batch, const SceneState& state, const BaseMotion& base,
                       const std::vector<EngineMotion>& advice, const Tensor& points_reference);

/// Per-vertex inputs of the encoder, [B, K, N, F]; padded vertices are zero.
/// Paper: displacement d to the nearest point of another object or the ground, increment v = x_t - x_{t-1}, offset
/// r = x_t - x_ref, and (mass, friction, restitution). Options of the model replace or extend them.
Tensor vertex_features(const ModelOptions& options, const SceneBatch& batch, const SceneState& state,
                       const BaseMotion& base, const Tensor& points_world, const Nearest& nearest);

}  // namespace rigidformer
