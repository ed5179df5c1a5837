// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/engine/observed_solid.hpp"
#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// A physics engine on what the network sees: Bullet on the convex hulls of the clouds (see observed_hull.hpp) with the
/// network's centres of mass [B, K, 3], to be called with the states of one rollout. Unknown material: the means of the
/// MOVi scenes. Empty for models without engine_motion. Throws BodyError for the first object without a body, and
/// std::runtime_error when the model needs an engine and none was there at build time.
EngineStep make_engine_step(const ModelOptions& options, const SceneBatch& batch, const Tensor& centre_reference);

}  // namespace rigidformer
