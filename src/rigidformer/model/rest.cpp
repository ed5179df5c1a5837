// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/rest.hpp"

#include <cmath>

namespace rigidformer {
namespace {

constexpr double kShareOfFall = 0.5;  // share of the speed that free fall from rest gains in a step; chosen by eye

/// Poses of several instants as one, [N, B, K, ...]: a step has few objects, so that the number of operations counts.
Pose stack(const Pose& a, const Pose& b, const Pose& c) {
  return {torch::stack({a.rotation, b.rotation, c.rotation}),
          torch::stack({a.translation, b.translation, c.translation})};
}

/// Whether each object moved less than the limits allow within one step of dt, [N, B, K] bool.
Tensor is_still(const Pose& from, const Pose& to, const Tensor& dt, const Tensor& max_speed, double max_spin) {
  const Tensor distance = (to.translation - from.translation).norm(2, -1);
  // The norm |R - R'| = sqrt(8) sin(angle / 2) is accurate for small angles, where the trace is not.
  const Tensor angle = (to.rotation - from.rotation).flatten(-2).norm(2, -1) / std::sqrt(2.0);
  return (distance < max_speed * dt).logical_and(angle < max_spin * dt);
}

/// The previous pose from which free motion would have just reached its highest point. An object that lies on something
/// has no velocity, and so has, for an instant, one at its highest point: this is the other way for two poses to say
/// "no velocity" (see StepPrediction::departure).
Pose highest_point_departure(const SceneBatch& batch, const Pose& departure) {
  const Tensor rise = 0.5 * (batch.gravity * batch.time_step().square()).reshape({-1, 1, 1});
  return {departure.rotation,
          torch::cat({departure.translation.slice(-1, 0, 2), departure.translation.slice(-1, 2) - rise}, -1)};
}

}  // namespace

void hold_resting(const SceneBatch& batch, const SceneState& last, SceneState& next, const RestLimits& limits,
                  const Tensor& exempt) {
  const Tensor dt = batch.time_step().unsqueeze(-1);  // [B, 1]
  const Tensor fall = kShareOfFall * batch.gravity.abs().unsqueeze(-1) * dt;
  const Tensor max_speed = fall.clamp_max(limits.speed_mps);
  const Pose raised = highest_point_departure(batch, last.previous);
  const Tensor may_be_held =
      exempt.defined() ? batch.dynamic_mask.logical_and(exempt.logical_not()) : batch.dynamic_mask;
  const Tensor still = is_still(stack(last.previous, raised, last.current),
                                stack(last.current, last.current, next.current), dt, max_speed, limits.spin_radps);
  const Tensor was_still = still[0].logical_or(still[1]);
  put_back(last, was_still.logical_and(still[2]).logical_and(may_be_held), next);
}

void put_back(const SceneState& last, const Tensor& held, SceneState& next) {
  const Tensor position = held.unsqueeze(-1), rotation = position.unsqueeze(-1);
  for (Pose* pose : {&next.previous, &next.current}) {
    pose->translation = torch::where(position, last.current.translation, pose->translation);
    pose->rotation = torch::where(rotation, last.current.rotation, pose->rotation);
  }
}

}  // namespace rigidformer
