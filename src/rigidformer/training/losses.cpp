// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/losses.hpp"

#include "rigidformer/engine/contact_search.hpp"
#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/model/centre_of_mass.hpp"

namespace rigidformer {
namespace {

constexpr std::int64_t kDirections = 64;  // drawn per loss, along which hulls are compared; chosen by eye

/// Smooth L1 (Eq. 7) of a residual [B, K, *, 3]: the sum over coordinates, and the mean
/// over the rest for valid objects.
Tensor smooth_l1(const Tensor& residual, const Tensor& object_mask, double beta) {
  const Tensor size = residual.abs();
  const Tensor value = torch::where(size < beta, 0.5 * residual.square() / beta, size - 0.5 * beta).sum(-1).mean(-1);
  const Tensor weight = object_mask.to(residual.scalar_type());
  return (value * weight).sum() / weight.sum().clamp_min(1.0);
}

/// Support function of clouds [B, K, N, 3]: how far they reach into directions [D, 3], as [B, K, D].
Tensor reach(const Tensor& points, const Tensor& mask, const Tensor& directions) {
  const Tensor along = torch::matmul(points, directions.t());
  return along.masked_fill(mask.logical_not().unsqueeze(-1), -1e6).amax(2);
}

/// What residuals of positions are divided by: a - a_gt = (q - q_gt) / dt^2, Eq. (10, 11).
Tensor residual_unit(const LossOptions& options, const Tensor& dt) {
  if (options.residual_unit == "dt") return dt;
  return options.residual_unit == "dt2" ? dt.square() : (dt * kFrameRateHz).square();
}

}  // namespace

Tensor step_loss(const LossOptions& options, const SceneBatch& batch, const StepPrediction& prediction,
                 const Pose& truth) {
  const Tensor q_reference = batch.anchors_reference();
  const Tensor q_truth = truth.apply(q_reference);
  const Tensor raw = prediction.anchors_raw - q_truth;                // Eq. (8)
  const Tensor rigid = prediction.pose.apply(q_reference) - q_truth;  // Eq. (9)
  const Tensor dt = batch.time_step().reshape({-1, 1, 1, 1});
  const Tensor unit = residual_unit(options, dt);
  const Tensor mask = batch.object_mask.logical_and(batch.dynamic_mask);
  const Tensor position = smooth_l1(raw, mask, options.beta) + smooth_l1(rigid, mask, options.beta);
  const Tensor acceleration = smooth_l1(raw / unit, mask, options.beta) + smooth_l1(rigid / unit, mask, options.beta);
  return options.position_weight * position + options.acceleration_weight * acceleration;  // Eq. (12)
}

Tensor end_velocity_loss(const LossOptions& options, const SceneBatch& batch, const StepPrediction& prediction,
                         const Pose& truth, const Pose& departure) {
  const Tensor q = batch.anchors_reference();
  const Tensor predicted_step = prediction.pose.apply(q) - prediction.departure.apply(q);
  const Tensor true_step = truth.apply(q) - departure.apply(q);
  const Tensor dt = batch.time_step().reshape({-1, 1, 1, 1});
  const Tensor mask = batch.object_mask.logical_and(batch.dynamic_mask);
  return options.end_velocity_weight * smooth_l1((predicted_step - true_step) / dt, mask, options.beta);
}

Tensor centre_of_mass_loss(const LossOptions& options, const SceneBatch& batch, const Tensor& centre_reference) {
  const Tensor radius = bounding_radius(batch.points_reference, batch.point_mask, torch::zeros_like(centre_reference));
  const Tensor residual = centre_reference / radius.clamp_min(1e-3).unsqueeze(-1);
  const Tensor mask = batch.object_mask.logical_and(batch.dynamic_mask);
  return options.centre_of_mass_weight * smooth_l1(residual.unsqueeze(2), mask, 0.1);
}

Tensor hidden_side_loss(const LossOptions& options, const WindowBatch& windows, const Tensor& hidden_points) {
  const SceneBatch& scene = windows.scene;
  const Tensor drawn = torch::randn({kDirections, 3}, hidden_points.options());
  const Tensor directions = drawn / drawn.norm(2, -1, true);
  const Tensor truth = reach(windows.whole_surface, windows.whole_mask, directions);
  const Tensor seen = reach(scene.surface_points, scene.surface_mask, directions);
  const Tensor completed =
      torch::maximum(seen, reach(hidden_points, scene.point_mask.slice(2, 0, hidden_points.size(2)), directions));
  const Tensor centre = torch::zeros_like(scene.properties);  // the origin of the reference frame
  const Tensor radius = bounding_radius(windows.whole_surface, windows.whole_mask, centre).clamp_min(1e-3);
  const Tensor residual =
      ((completed - truth) / radius.unsqueeze(-1)).masked_fill(scene.object_mask.logical_not().unsqueeze(-1), 0.0);
  return options.hidden_side_weight * smooth_l1(residual.unsqueeze(-1), scene.object_mask, 0.05);
}

Tensor window_loss(const LossOptions& options, RigidFormer& model, const WindowBatch& windows,
                   const NearestSearch& nearest_search) {
  SceneBatch scene = windows.scene;
  SceneState state{windows.poses[0], windows.poses[0], windows.poses[1]};
  const Tensor centre = model->centre_of_mass(scene, state.current);
  const Tensor hidden = model->hidden_side(scene, state.current, centre.detach());
  if (hidden.defined()) scene.hidden_points = hidden.detach();
  const size_t num_steps = windows.poses.size() - 2;
  const EngineStep engine = num_steps > 0 ? make_engine_step(model->options, scene, centre) : EngineStep();
  const ContactSearch search = num_steps > 0 ? make_contact_search(model->options, scene, centre) : ContactSearch();
  Tensor loss = torch::zeros({}, scene.points_reference.options());
  for (size_t step = 0; step < num_steps; ++step) {
    if (!windows.controls.empty()) scene.control = windows.controls[step];
    const Pose& truth = windows.poses[step + 2];
    state.coming = truth;  // of what is given: a planner knows it
    // The centre of mass learns from its own loss alone: it must not be a free parameter of the motion.
    const StepPrediction prediction = model->forward(scene, state, centre.detach(), nearest_search, engine, search);
    loss = loss + step_loss(options, scene, prediction, truth);
    if (model->options.end_velocity_output) {
      loss = loss + end_velocity_loss(options, scene, prediction, truth, windows.departures[step]);
    }
    state = advance(scene, state, prediction);
  }
  if (num_steps > 0) loss = loss / static_cast<double>(num_steps);
  if (options.centre_of_mass_weight > 0.0) loss = loss + centre_of_mass_loss(options, scene, centre);
  if (hidden.defined()) loss = loss + hidden_side_loss(options, windows, hidden);
  return loss;
}

}  // namespace rigidformer
