// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/base_motion.hpp"

#include "rigidformer/model/given_motion.hpp"

namespace rigidformer {

Tensor BaseMotion::apply(const Tensor& points_reference) const {
  if (inertial) return pose.apply(points_reference);
  const Tensor lines = 2.0 * current.apply(points_reference) - previous.apply(points_reference);
  return torch::where(dynamic_mask.unsqueeze(-1).unsqueeze(-1), lines, given.apply(points_reference));
}

BaseMotion make_base_motion(const ModelOptions& options, const SceneBatch& batch, const SceneState& state,
                            const Tensor& centre_reference) {
  BaseMotion base;
  base.inertial = options.inertial_base_motion;
  base.current = state.current;
  base.previous = state.previous;
  base.given = coming_pose(state);
  base.dynamic_mask = batch.dynamic_mask;
  const Tensor c_ref = centre_reference.unsqueeze(2);
  const Tensor centre_now = state.current.apply(c_ref).squeeze(2);
  const Tensor centre_before = state.previous.apply(c_ref).squeeze(2);
  base.centre = centre_now;
  const Tensor dynamic = batch.dynamic_mask.unsqueeze(-1);
  base.centre_step = torch::where(dynamic, centre_now - centre_before, base.given.apply(c_ref).squeeze(2) - centre_now);
  if (base.inertial) {
    const Tensor fall = (batch.gravity * batch.time_step().square()).reshape({-1, 1, 1});  // g dt^2
    const Tensor down = fall * dynamic.to(fall.scalar_type());
    base.centre_step = torch::cat({base.centre_step.slice(-1, 0, 2), base.centre_step.slice(-1, 2) + down}, -1);
    const Tensor spin = torch::matmul(state.current.rotation, state.previous.rotation.transpose(-1, -2));
    const Tensor rotation = torch::matmul(spin, state.current.rotation);
    const Tensor translation =
        centre_now + base.centre_step - torch::matmul(rotation, centre_reference.unsqueeze(-1)).squeeze(-1);
    base.pose = {torch::where(dynamic.unsqueeze(-1), rotation, base.given.rotation),
                 torch::where(dynamic, translation, base.given.translation)};
  }
  return base;
}

namespace {

/// Smallest distance from the origin to the segment start + u * step, u in [0, 1]. Shapes [..., 3] -> [...].
Tensor closest_approach(const Tensor& start, const Tensor& step) {
  const Tensor u = (-(start * step).sum(-1) / step.square().sum(-1).clamp_min(1e-12)).clamp(0.0, 1.0);
  return (start + u.unsqueeze(-1) * step).norm(2, -1);
}

}  // namespace

Tensor contact_gate(const SceneBatch& batch, const BaseMotion& base, const Tensor& radius, double margin_m) {
  torch::NoGradGuard no_grad;
  const std::int64_t K = batch.max_objects();
  const Tensor start = base.centre.unsqueeze(2) - base.centre.unsqueeze(1);  // [B, K, K, 3]
  const Tensor step = base.centre_step.unsqueeze(2) - base.centre_step.unsqueeze(1);
  const Tensor reach = radius.unsqueeze(2) + radius.unsqueeze(1) + margin_m;
  const Tensor both_valid = batch.object_mask.unsqueeze(2).logical_and(batch.object_mask.unsqueeze(1));
  const Tensor other = torch::eye(K, batch.object_mask.options()).logical_not();
  const Tensor touching = (closest_approach(start, step) < reach).logical_and(both_valid).logical_and(other).any(-1);

  const Tensor height = base.centre.select(-1, 2) - batch.ground_height.unsqueeze(-1) - radius;
  const Tensor lowest = torch::minimum(height, height + base.centre_step.select(-1, 2));
  return touching.logical_or(lowest < margin_m).logical_and(batch.object_mask);
}

}  // namespace rigidformer
