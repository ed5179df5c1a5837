// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"

namespace rigidformer {

/// Below both speeds an object is held still (physics engines call it sleeping).
struct RestLimits {
  double speed_mps = 0.1;  ///< Speed below which an object may be still; 0 = nothing is ever held
  double spin_radps = 0.3;
};

/// Holds every dynamic object still that was still over the last step and would stay so over the next one.
/// Otherwise errors of a millimetre per step would make a table full of things wander. An object that has just
/// begun to fall is not held: it moves faster within one step than the limit, which shrinks with the time
/// step. Nor is what `exempt` [B, K] bool says (undefined = nothing): a slow finger would sink into what it pushes.
/// Changes the poses of `next`.
void hold_resting(const SceneBatch& batch, const SceneState& last, SceneState& next, const RestLimits& limits,
                  const Tensor& exempt = {});

/// Puts those that `held` [B, K] bool names back to where `last` has them, at rest.
void put_back(const SceneState& last, const Tensor& held, SceneState& next);

}  // namespace rigidformer
