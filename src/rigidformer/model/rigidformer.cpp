// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/rigidformer.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "rigidformer/model/features.hpp"
#include "rigidformer/model/given_motion.hpp"
#include "rigidformer/model/rigid_projection.hpp"

namespace rigidformer {
namespace {

constexpr double kStepUnit = 10.0;         // recorded frames; keeps the FiLM code (s, s^2) near one for s = 1 ... 10
constexpr double kPositionUnit = 5.0;      // [m] half the width of the MOVi arena
constexpr double kFirstEngineLogit = 1.5;  // training starts with an engine share of 0.9; chosen by eye
constexpr double kEngineShareScale = 1.1;  // above 1, so that a share of exactly 1 is reached; chosen by eye

/// FiLM code (s, s^2, c) of §3.1 and App. I, [B, 2 + control_dim].
Tensor film_code(const ModelOptions& options, const SceneBatch& batch) {
  const Tensor s = batch.time_step().unsqueeze(-1) * (options.frame_rate_hz / kStepUnit);
  const std::int64_t width = batch.control.defined() ? batch.control.size(-1) : 0;
  if (width != options.control_dim) {
    throw std::invalid_argument("the scene has a command of " + std::to_string(width) + " numbers, the model wants " +
                                std::to_string(options.control_dim));
  }
  return width == 0 ? torch::cat({s, s.square()}, -1) : torch::cat({s, s.square(), batch.control}, -1);
}

/// The points [B, K, P, 3] that tell what an object is, in world coordinates, and a mask of the valid ones.
struct ShapePoints {
  Tensor world, mask;
};

ShapePoints shape_points(const SceneBatch& batch, const Pose& current) {
  return {current.apply(batch.points_reference.slice(2, 0, kShapePoints)), batch.point_mask.slice(2, 0, kShapePoints)};
}

}  // namespace

RigidFormerImpl::RigidFormerImpl(const ModelOptions& model_options) : options(model_options) {
  validate(options);
  if (options.centre_of_mass_head) {
    centre_of_mass_head = register_module("centre_of_mass_head", CentreOfMassHead());
  }
  if (options.hidden_side_head) hidden_side_head = register_module("hidden_side_head", HiddenSideHead());
  encoder = register_module("encoder", PointEncoder(options));
  position_encoder = register_module("position_encoder", TokenPositionEncoder(options));
  decoder = register_module("decoder", ObjectDecoder(options, 2 + options.control_dim));
  anchor_vertex_pooling = register_module("anchor_vertex_pooling", AnchorVertexPooling(options));
  predictor = register_module("predictor", AnchorPredictor(options));
  if (options.contact_tokens) contact_tokens = register_module("contact_tokens", ContactTokens(options));
}

Tensor RigidFormerImpl::centre_of_mass(const SceneBatch& batch, const Pose& current) {
  if (centre_of_mass_head.is_empty()) return centroid(batch.points_reference, batch.point_mask);
  const ShapePoints points = shape_points(batch, current);
  const Tensor centre_world = centre_of_mass_head(points.world, points.mask);
  const Tensor offset = (centre_world - current.translation).unsqueeze(-1);
  return torch::matmul(current.rotation.transpose(-1, -2), offset).squeeze(-1);
}

Tensor RigidFormerImpl::hidden_side(const SceneBatch& batch, const Pose& current, const Tensor& centre_reference) {
  if (hidden_side_head.is_empty()) return {};
  const Tensor centre_world = current.apply(centre_reference.unsqueeze(2)).squeeze(2);
  const ShapePoints points = shape_points(batch, current);
  const Tensor hidden_world = hidden_side_head(points.world, points.mask, centre_world);
  return torch::matmul(hidden_world - current.translation.unsqueeze(2), current.rotation);
}

StepPrediction RigidFormerImpl::forward(const SceneBatch& batch, const SceneState& state,
                                        const Tensor& centre_reference, const NearestSearch& nearest_search,
                                        const EngineStep& engine_step, const ContactSearch& contact_search) {
  if (options.engine_motion && !engine_step) throw std::invalid_argument("this model needs a physics engine's step");
  if (options.contact_tokens && !contact_search) throw std::invalid_argument("this model needs a search for contacts");
  const Tensor x = state.current.apply(batch.points_reference);
  const Nearest nearest = nearest_search(batch, state.current, x);
  const BaseMotion base = make_base_motion(options, batch, state, centre_reference);
  const std::vector<EngineMotion> advice = options.engine_motion ? engine_step(state) : std::vector<EngineMotion>();
  const Contacts contacts = options.contact_tokens ? contact_search(state.current, base.pose) : Contacts();
  const Tensor outputs = predict_anchor_outputs(batch, state, base, x, nearest, advice, contacts);

  AnchorDeviation deviation = deviation_of(batch, outputs);
  if (options.engine_motion) mix_with_engine(batch, state, base, advice, engine_shares(outputs), deviation);
  if (options.contact_gate) close_contact_gate(batch, base, x, deviation);

  const Tensor q = batch.anchors_reference();
  const Tensor q_hat = base.apply(q) + deviation.over_step;
  StepPrediction prediction{q_hat, align_rigidly(q, q_hat, options.differentiable_alignment), state.current};
  if (deviation.beyond.defined()) {
    // When something was hit on the way, the mean velocity of a step is not the velocity at its end.
    const Tensor q_departure = state.current.apply(q) - deviation.beyond;
    prediction.departure = align_rigidly(q, q_departure, options.differentiable_alignment);
  }
  return prediction;
}

Tensor RigidFormerImpl::predict_anchor_outputs(const SceneBatch& batch, const SceneState& state, const BaseMotion& base,
                                               const Tensor& x, const Nearest& nearest,
                                               const std::vector<EngineMotion>& advice, const Contacts& contacts) {
  const auto geometry_type = x.scalar_type();
  Tensor h = vertex_features(options, batch, state, base, x, nearest);
  const Tensor q = gather_points(x, batch.anchor_index);
  const TokenPositions positions = position_encoder(batch, state.current, x, q);
  Tensor anchor_state = torch::cat({gather_points(h, batch.anchor_index), q / kPositionUnit}, -1).to(compute_type);
  if (options.ground_material) h = torch::cat({h, ground_features(options, batch, h.size(2))}, -1);
  Tensor engine_at_anchors;
  if (options.engine_motion) {
    const Tensor e = engine_features(batch, state, base, advice, batch.points_reference)
                         .masked_fill(batch.point_mask.logical_not().unsqueeze(-1), 0.0);
    h = torch::cat({h, e}, -1);
    engine_at_anchors = gather_points(e, batch.anchor_index).to(compute_type);
  }

  // Interaction of objects (§3.1)
  const Encoding encoding = encoder(h.to(compute_type), batch.point_mask);
  TokenSet objects{encoding.tokens, batch.object_mask, positions.object_angles};
  if (positions.object_embedding.defined()) {
    objects.tokens = objects.tokens + positions.object_embedding.to(compute_type);
  }
  ContactDescription described;
  Tensor contact_embedding;
  if (options.contact_tokens) {
    described = describe_contacts(options, batch, state, base, contacts);
    contact_embedding = contact_tokens->embed(described);
    objects.tokens = objects.tokens + contact_tokens->to_objects(contact_embedding, described, objects.tokens);
  }
  const std::vector<Tensor> Z = decoder(objects, film_code(options, batch).to(compute_type));

  // Interaction of anchors with objects (§3.2)
  const Tensor u = anchor_vertex_pooling(encoding.vertex_features, x, batch.point_mask, q);
  anchor_state = torch::cat({anchor_state, u}, -1);
  if (options.contact_tokens) {
    const Tensor at_anchors = ContactTokensImpl::to_anchors(described, x.size(0), x.size(1));
    anchor_state = torch::cat({anchor_state, at_anchors.to(compute_type)}, -1);
  }
  if (options.ground_material) {
    anchor_state = torch::cat({anchor_state, ground_features(options, batch, q.size(2)).to(compute_type)}, -1);
  }
  if (engine_at_anchors.defined()) anchor_state = torch::cat({anchor_state, engine_at_anchors}, -1);
  const Tensor outputs =
      predictor(anchor_state, Z, objects, positions.anchor_angles, positions.anchor_embedding).to(geometry_type);
  if (!options.contact_tokens) return outputs;
  return outputs + torch::constant_pad_nd(contact_tokens->answer(contact_embedding, described, Z.back()),
                                          {0, outputs.size(-1) - 6});
}

/// Shares of the advisers' steps in the prediction, [B, K, A, advisers]; the network's own has the rest. Training
/// starts by trusting the engine mostly, and all of its advisers alike.
Tensor RigidFormerImpl::engine_shares(const Tensor& outputs) const {
  const Tensor logits = outputs.slice(-1, 6) + (kFirstEngineLogit - std::log(options.advisers));
  if (fixed_engine_share) {
    return torch::constant_pad_nd(torch::full_like(logits.slice(-1, 0, 1), *fixed_engine_share),
                                  {0, options.advisers - 1});
  }
  const Tensor shares = torch::cat({torch::zeros_like(logits.slice(-1, 0, 1)), logits}, -1).softmax(-1).slice(-1, 1);
  const Tensor together = shares.sum(-1, true);
  return shares / together * (kEngineShareScale * together).clamp_max(1.0);
}

RigidFormerImpl::AnchorDeviation RigidFormerImpl::deviation_of(const SceneBatch& batch, const Tensor& outputs) const {
  const Tensor dt = batch.time_step().reshape({-1, 1, 1, 1});
  // Verlet (§3.2): q_hat = a dt^2 + 2 q_t - q_{t-1}. A velocity output stands for a = output / dt.
  AnchorDeviation deviation{outputs.slice(-1, 0, 3) * (options.velocity_output ? dt : dt.square()), Tensor()};
  if (options.end_velocity_output) deviation.beyond = outputs.slice(-1, 3, 6) * dt;
  return deviation;
}

void RigidFormerImpl::mix_with_engine(const SceneBatch& batch, const SceneState& state, const BaseMotion& base,
                                      const std::vector<EngineMotion>& advice, const Tensor& shares,
                                      AnchorDeviation& deviation) const {
  const Tensor q = batch.anchors_reference(), moved_freely = base.apply(q), q_world = state.current.apply(q);
  const Tensor own_share = 1.0 - shares.sum(-1, true);
  deviation.over_step = deviation.over_step * own_share;
  deviation.beyond = deviation.beyond * own_share;
  for (size_t i = 0; i < advice.size(); ++i) {
    const Tensor share = shares.slice(-1, static_cast<std::int64_t>(i), static_cast<std::int64_t>(i) + 1);
    deviation.over_step = deviation.over_step + share * (advice[i].pose.apply(q) - moved_freely);
    deviation.beyond = deviation.beyond + share * (q_world - advice[i].departure.apply(q));
  }
}

void RigidFormerImpl::close_contact_gate(const SceneBatch& batch, const BaseMotion& base, const Tensor& x,
                                         AnchorDeviation& deviation) const {
  const Tensor radius = bounding_radius(x.detach(), batch.point_mask, base.centre.detach());
  const Tensor open = contact_gate(batch, base, radius, options.contact_gate_margin_m)
                          .unsqueeze(-1)
                          .unsqueeze(-1)
                          .to(deviation.over_step.scalar_type());
  deviation.over_step = deviation.over_step * open;
  if (deviation.beyond.defined()) deviation.beyond = deviation.beyond * open;
}

SceneState advance(const SceneBatch& batch, const SceneState& state, const StepPrediction& prediction) {
  const Pose given = coming_pose(state);
  const Tensor predicted = batch.dynamic_mask.unsqueeze(-1);
  const auto choose = [&](const Pose& pose, const Pose& otherwise) {
    return Pose{torch::where(predicted.unsqueeze(-1), pose.rotation, otherwise.rotation),
                torch::where(predicted, pose.translation, otherwise.translation)};
  };
  SceneState after = state;
  after.previous = choose(prediction.departure, state.current);
  after.current = choose(prediction.pose, given);
  after.coming = {};
  return after;
}

std::int64_t count_parameters(const torch::nn::Module& module) {
  std::int64_t count = 0;
  for (const auto& parameter : module.parameters()) count += parameter.numel();
  return count;
}

}  // namespace rigidformer
