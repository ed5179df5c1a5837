// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/rest.hpp"

#include <cmath>

namespace rigidformer {
namespace {

constexpr double kShareOfFall = 0.5;  // of the speed that free fall from rest reaches within a step

/// Whether each object moved less than the limits allow within one step of dt, [B, K] bool.
Tensor is_still(const Pose& from, const Pose& to, const Tensor& dt, const Tensor& max_speed, double max_spin) {
  const Tensor distance = (to.translation - from.translation).norm(2, -1);
  // |R - R'| = sqrt(8) sin(angle / 2), accurate for small angles where the trace is not.
  const Tensor angle = (to.rotation - from.rotation).flatten(-2).norm(2, -1) / std::sqrt(2.0);
  return (distance < max_speed * dt).logical_and(angle < max_spin * dt);
}

}  // namespace

void hold_resting(const SceneBatch& batch, const SceneState& last, SceneState& next, const RestLimits& limits) {
  const Tensor dt = batch.time_step().unsqueeze(-1);  // [B, 1]
  const Tensor fall = kShareOfFall * batch.gravity.abs().unsqueeze(-1) * dt;
  const Tensor max_speed = fall.clamp_max(limits.speed_mps);
  const Tensor held = is_still(last.previous, last.current, dt, max_speed, limits.spin_radps)
                          .logical_and(is_still(last.current, next.current, dt, max_speed, limits.spin_radps))
                          .logical_and(batch.dynamic_mask)
                          .unsqueeze(-1);
  next.current.translation = torch::where(held, last.current.translation, next.current.translation);
  next.current.rotation = torch::where(held.unsqueeze(-1), last.current.rotation, next.current.rotation);
}

}  // namespace rigidformer
