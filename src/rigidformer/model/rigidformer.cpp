// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/rigidformer.hpp"

#include "rigidformer/model/features.hpp"
#include "rigidformer/model/rigid_projection.hpp"

namespace rigidformer {
namespace {

constexpr double kStepUnit = 10.0;     // frames; keeps the FiLM code (s, s^2) near one
constexpr double kPositionUnit = 5.0;  // [m] half the MOVi arena

/// FiLM code (s, s^2, c) of §3.1 and App. I, [B, 2 + control_dim]. A scene without a command has c = 0.
Tensor film_code(const ModelOptions& options, const SceneBatch& batch) {
  const Tensor s = batch.step_size.unsqueeze(-1) / kStepUnit;
  const Tensor c =
      batch.control.defined() ? batch.control : torch::zeros({s.size(0), options.control_dim}, s.options());
  return torch::cat({s, s.square(), c}, -1);
}

/// One Newton step towards the nearest rotation. Products of rotations alone would let rounding errors grow
/// exponentially: each step multiplies them by 1 + sqrt(2).
Tensor orthonormalized(const Tensor& R) {
  return 1.5 * R - 0.5 * torch::matmul(R, torch::matmul(R.transpose(-1, -2), R));
}

}  // namespace

RigidFormerImpl::RigidFormerImpl(const ModelOptions& model_options) : options(model_options) {
  validate(options);
  if (options.centre_of_mass_head) {
    centre_of_mass_head = register_module("centre_of_mass_head", CentreOfMassHead());
  }
  encoder = register_module("encoder", PointEncoder(options));
  position_encoder = register_module("position_encoder", TokenPositionEncoder(options));
  decoder = register_module("decoder", ObjectDecoder(options, 2 + options.control_dim));
  anchor_vertex_pooling = register_module("anchor_vertex_pooling", AnchorVertexPooling(options));
  predictor = register_module("predictor", AnchorPredictor(options));
}

Tensor RigidFormerImpl::centre_of_mass(const SceneBatch& batch, const Pose& current) {
  if (centre_of_mass_head.is_empty()) return centroid(batch.points_reference, batch.point_mask);
  const Tensor centre_world = centre_of_mass_head(current.apply(batch.points_reference), batch.point_mask);
  const Tensor offset = (centre_world - current.translation).unsqueeze(-1);
  return torch::matmul(current.rotation.transpose(-1, -2), offset).squeeze(-1);
}

StepPrediction RigidFormerImpl::forward(const SceneBatch& batch, const SceneState& state,
                                        const Tensor& centre_reference, const NearestSearch& nearest_search) {
  const Tensor x = state.current.apply(batch.points_reference);
  const Nearest nearest = nearest_search(batch, state.current, x);
  const BaseMotion base = make_base_motion(options, batch, state, centre_reference);
  const Tensor outputs = predict_anchor_outputs(batch, state, base, x, nearest);
  const Tensor radius = bounding_radius(x.detach(), batch.point_mask, base.centre.detach());
  const Tensor q_hat = advance_anchors(batch, base, outputs, radius);
  return {q_hat, align_rigidly(batch.anchors_reference(), q_hat, options.differentiable_alignment)};
}

Tensor RigidFormerImpl::predict_anchor_outputs(const SceneBatch& batch, const SceneState& state, const BaseMotion& base,
                                               const Tensor& x, const Nearest& nearest) {
  const auto geometry_type = x.scalar_type();
  const Tensor h = vertex_features(options, batch, state, base, x, nearest).to(compute_type);
  const Tensor q = gather_points(x, batch.anchor_index);
  const TokenPositions positions = position_encoder(batch, state.current, x, q);

  // Object-level interaction (§3.1)
  const Encoding encoding = encoder(h, batch.point_mask);
  TokenSet objects{encoding.tokens, batch.object_mask, positions.object_angles};
  if (positions.object_embedding.defined()) {
    objects.tokens = objects.tokens + positions.object_embedding.to(compute_type);
  }
  const std::vector<Tensor> Z = decoder(objects, film_code(options, batch).to(compute_type));

  // Anchor-object interaction (§3.2)
  const Tensor u = anchor_vertex_pooling(encoding.vertex_features, x, batch.point_mask, q);
  const Tensor anchor_features = gather_points(h, batch.anchor_index);
  const Tensor anchor_position = (q / kPositionUnit).to(compute_type);
  return predictor(torch::cat({anchor_features, anchor_position, u}, -1), Z, objects, positions.anchor_angles,
                   positions.anchor_embedding)
      .to(geometry_type);
}

Tensor RigidFormerImpl::advance_anchors(const SceneBatch& batch, const BaseMotion& base, const Tensor& outputs,
                                        const Tensor& radius) const {
  const Tensor dt = batch.time_step().reshape({-1, 1, 1, 1});
  // Verlet (§3.2): q_hat = a dt^2 + 2 q_t - q_{t-1}. A velocity output stands for a = output / dt.
  Tensor step = options.velocity_output ? outputs * dt : outputs * dt.square();
  if (options.contact_gate) {
    const Tensor gate = contact_gate(batch, base, radius, options.contact_gate_margin_m);
    step = step * gate.unsqueeze(-1).unsqueeze(-1).to(step.scalar_type());
  }
  return base.apply(batch.anchors_reference()) + step;
}

SceneState advance(const SceneBatch& batch, const SceneState& state, const Pose& next) {
  // Objects whose motion is given keep the twist between their two states; for static ones that is rest.
  const Tensor spin = torch::matmul(state.current.rotation, state.previous.rotation.transpose(-1, -2));
  const Tensor step = (state.current.translation - state.previous.translation).unsqueeze(-1);
  const Tensor given_translation = state.current.translation + torch::matmul(spin, step).squeeze(-1);
  const Tensor given_rotation = orthonormalized(torch::matmul(spin, state.current.rotation));

  const Tensor predicted = batch.dynamic_mask.unsqueeze(-1);
  SceneState after = state;
  after.previous = state.current;
  after.current.translation = torch::where(predicted, next.translation, given_translation);
  after.current.rotation = torch::where(predicted.unsqueeze(-1), next.rotation, given_rotation);
  return after;
}

int64_t count_parameters(const torch::nn::Module& module) {
  int64_t count = 0;
  for (const auto& parameter : module.parameters()) count += parameter.numel();
  return count;
}

}  // namespace rigidformer
