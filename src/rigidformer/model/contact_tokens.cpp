// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/contact_tokens.hpp"

#include "rigidformer/model/features.hpp"

namespace rigidformer {
namespace {

constexpr std::int64_t kTokenFeatures = 24;  // without the ground
constexpr std::int64_t kTokenWidth = 64;     // E; chosen by eye
constexpr std::int64_t kShareHidden = 128;   // chosen by eye
constexpr std::int64_t kShares = 8;          // {over the step, beyond} x {normal, tangent} x {linear, angular}
constexpr double kVelocityUnit = 5.0;        // [m/s] chosen by eye, as for the vertices
constexpr double kGapUnits[] = {0.01, 0.1};  // [m] scales of squashed gaps; chosen by eye
constexpr double kSmallestSpeed2 = 1e-8;     // [m^2/s^2] keeps the direction of sliding defined
constexpr double kSmallestShare = 1e-6;      // of an inertia, keeps divisions defined

Tensor along(const Tensor& a, const Tensor& b) { return (a * b).sum(-1, true); }
Tensor cross_product(const Tensor& a, const Tensor& b) { return torch::cross(a, b, -1); }
Tensor rotated(const Tensor& R, const Tensor& v) { return torch::matmul(R, v.unsqueeze(-1)).squeeze(-1); }

/// Rotation vectors [..., 3] of rotations [..., 3, 3] by less than half a turn.
Tensor rotation_vectors(const Tensor& R) {
  const auto at = [&](std::int64_t i, std::int64_t j) { return R.select(-2, i).select(-1, j); };
  const Tensor twice_sine = torch::stack({at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1)}, -1);
  const Tensor sine = 0.5 * (twice_sine.square().sum(-1, true) + 1e-12).sqrt();
  const Tensor cosine = 0.5 * (R.diagonal(0, -2, -1).sum(-1, true) - 1.0);
  return 0.5 * twice_sine * torch::atan2(sine, cosine) / sine;
}

/// One side of the contacts: how its body moves in free motion when they happen, and how it yields to an impulse there.
struct Side {
  Tensor arm;              ///< [C, 3] m, contact seen from the centre of mass
  Tensor inverse_mass;     ///< [C, 1]; 0 for what nothing moves
  Tensor inverse_inertia;  ///< [C, 3, 3] per unit of mass, world axes
  Tensor velocity;         ///< [C, 3] of its surface at the contact [m/s]

  /// Velocity per impulse along the unit vectors n at the contact, seen along n, relative to that of the centre: 1 +
  /// ...
  Tensor yield(const Tensor& n) const { return 1.0 + along(n, cross_product(turn(n), arm)); }
  /// Spin per impulse and unit of mass.
  Tensor turn(const Tensor& n) const { return rotated(inverse_inertia, cross_product(arm, n)); }
};

/// What holds for bodies [B * K, ...] from now to the end of the step.
struct Bodies {
  Tensor velocity, spin, inverse_mass, inverse_inertia, falls;
};

Bodies moving_bodies(const SceneBatch& batch, const SceneState& state, const BaseMotion& base,
                     const Contacts& contacts) {
  const Tensor dt = batch.time_step().reshape({-1, 1, 1});
  const Tensor turn = torch::matmul(base.pose.rotation, state.current.rotation.transpose(-1, -2));
  const Tensor R = state.current.rotation;
  const Tensor dynamic = batch.dynamic_mask.unsqueeze(-1).to(dt.scalar_type());
  return {(base.centre_step / dt).flatten(0, 1), (rotation_vectors(turn) / dt).flatten(0, 1),
          (dynamic / contacts.mass.unsqueeze(-1)).flatten(0, 1),
          torch::matmul(R, torch::matmul(contacts.inverse_inertia, R.transpose(-1, -2))).flatten(0, 1),
          dynamic.flatten(0, 1)};
}

Side side_of(const Bodies& bodies, const Tensor& row, const Tensor& arm, const Tensor& speed_gained) {
  const auto of = [&](const Tensor& values) { return values.index_select(0, row); };
  // Free motion gains speed by gravity: what base motion has is the mean over the step.
  const Tensor fall = torch::cat({torch::zeros_like(arm.slice(-1, 0, 2)), speed_gained * of(bodies.falls)}, -1);
  return {arm, of(bodies.inverse_mass), of(bodies.inverse_inertia),
          of(bodies.velocity) + fall + cross_product(of(bodies.spin), arm)};
}

Tensor squashed_gap(const Tensor& gap) {
  std::vector<Tensor> scales;
  for (const double unit : kGapUnits) scales.push_back(gap / (gap.abs() + unit));
  return torch::cat(scales, -1);
}

/// [C, n, 3] for n vectors [C, 3].
Tensor stacked(const Tensor& a, const Tensor& b) { return torch::stack({a, b}, 1); }

/// The unit answers at the anchors, [C, 2, A, 3]: what the linear and what the angular parts do there.
Tensor linear_at_anchors(const ContactDescription& contacts) {
  return contacts.answers.linear.unsqueeze(2).expand({-1, -1, contacts.arms.size(1), -1});
}
Tensor angular_at_anchors(const ContactDescription& contacts) {
  const auto shape = std::vector<std::int64_t>{contacts.arms.size(0), 2, contacts.arms.size(1), 3};
  return cross_product(contacts.answers.angular.unsqueeze(2).expand(shape), contacts.arms.unsqueeze(1).expand(shape));
}

/// Sums rows [C, ...] per object: [B * K, ...].
Tensor sum_per_object(const Tensor& rows, const Tensor& row, std::int64_t num_objects) {
  std::vector<std::int64_t> shape = rows.sizes().vec();
  shape[0] = num_objects;
  return torch::zeros(shape, rows.options()).index_add(0, row, rows);
}

}  // namespace

std::int64_t num_token_features(const ModelOptions& options) {
  return kTokenFeatures + (options.ground_material ? kGroundCode : 0);
}

ContactDescription describe_contacts(const ModelOptions& options, const SceneBatch& batch, const SceneState& state,
                                     const BaseMotion& base, const Contacts& contacts) {
  const std::int64_t K = batch.max_objects();
  ContactDescription described;
  described.row = contacts.scene * K + contacts.object;
  described.on_ground = (contacts.partner < 0).unsqueeze(-1);
  described.partner_row = contacts.scene * K + torch::where(contacts.partner < 0, contacts.object, contacts.partner);

  const Tensor dt = batch.time_step().index_select(0, contacts.scene).unsqueeze(-1);
  const Tensor gravity = batch.gravity.index_select(0, contacts.scene).unsqueeze(-1);
  const Tensor fraction = contacts.fraction.unsqueeze(-1), gap = contacts.gap.unsqueeze(-1);
  const Tensor speed_gained = gravity * dt * (fraction - 0.5);
  const Bodies bodies = moving_bodies(batch, state, base, contacts);
  const Side own = side_of(bodies, described.row, contacts.point, speed_gained);
  Side other = side_of(bodies, described.partner_row, contacts.partner_point, speed_gained);
  other.velocity = other.velocity.masked_fill(described.on_ground, 0.0);
  other.inverse_mass = other.inverse_mass.masked_fill(described.on_ground, 0.0);

  const Tensor n = contacts.normal;
  const Tensor relative = other.velocity - own.velocity;
  const Tensor approach = along(relative, n);
  const Tensor sliding = relative - approach * n;
  const Tensor sliding_speed = (sliding.square().sum(-1, true) + kSmallestSpeed2).sqrt();
  const Tensor t = sliding / sliding_speed;
  // The share of the own body in how the pair yields to an impulse, per unit of velocity at the contact.
  const auto share = [&](const Tensor& direction) {
    const Tensor total = own.inverse_mass * own.yield(direction) + other.inverse_mass * other.yield(direction);
    return own.inverse_mass / total.clamp_min(kSmallestShare);
  };
  const Tensor normal_answer = share(n) * approach.clamp_min(0.0), tangent_answer = share(t) * sliding_speed;
  described.answers = {stacked(normal_answer * n, tangent_answer * t),
                       stacked(normal_answer * own.turn(n), tangent_answer * own.turn(t))};

  const Tensor q = state.current.apply(batch.anchors_reference()) - base.centre.unsqueeze(2);
  described.arms = q.flatten(0, 1).index_select(0, described.row);
  const auto material = [&](const Tensor& row) {
    const Tensor known = batch.properties_known.flatten(0, 1).index_select(0, row).slice(-1, 1);
    return torch::cat({batch.properties.flatten(0, 1).index_select(0, row).slice(-1, 1) * known, known}, -1);
  };
  const Tensor ground = described.on_ground.to(dt.scalar_type());
  described.features =
      torch::cat({fraction, fraction.square(), squashed_gap(gap), squashed_gap(gap - approach * dt * (1.0 - fraction)),
                  approach / kVelocityUnit, approach.clamp_min(0.0) / (approach.abs() + 0.5),
                  sliding_speed / kVelocityUnit, sliding_speed / (sliding_speed + approach.abs() + 0.1), share(n),
                  own.yield(n).reciprocal(), own.yield(t).reciprocal(), n.slice(-1, 2), ground, dt * 24.0,
                  material(described.row), material(described.partner_row) * (1.0 - ground)},
                 -1);
  if (options.ground_material) {
    const Tensor ground_code = batch.ground_code().index_select(0, contacts.scene) * ground;
    described.features = torch::cat({described.features, ground_code}, -1);
  }
  return described;
}

ContactTokensImpl::ContactTokensImpl(const ModelOptions& options) {
  embedding = register_module("embedding", Mlp(num_token_features(options), kTokenWidth, kTokenWidth));
  object_part = register_module("object_part", Linear(kTokenWidth, options.embedding_dim, false));
  object_part->zero();
  share =
      register_module("share", Mlp(kTokenWidth + 2 * options.embedding_dim, kShareHidden, kShares, /*zero_last=*/true));
}

Tensor ContactTokensImpl::embed(const ContactDescription& contacts) {
  return torch::silu(embedding(contacts.features));
}

Tensor ContactTokensImpl::to_objects(const Tensor& tokens, const ContactDescription& contacts,
                                     const Tensor& object_tokens) {
  const std::int64_t B = object_tokens.size(0), K = object_tokens.size(1);
  return sum_per_object(object_part(tokens), contacts.row, B * K).unflatten(0, {B, K}).to(object_tokens.scalar_type());
}

Tensor ContactTokensImpl::to_anchors(const ContactDescription& contacts, std::int64_t B, std::int64_t K) {
  const Tensor at_anchors = (linear_at_anchors(contacts) + angular_at_anchors(contacts)) / kVelocityUnit;
  return sum_per_object(at_anchors.transpose(1, 2).flatten(2), contacts.row, B * K).unflatten(0, {B, K});
}

Tensor ContactTokensImpl::answer(const Tensor& tokens, const ContactDescription& contacts,
                                 const Tensor& decoder_output) {
  const std::int64_t B = decoder_output.size(0), K = decoder_output.size(1);
  const Tensor objects = decoder_output.flatten(0, 1).to(tokens.scalar_type());
  const Tensor partner = objects.index_select(0, contacts.partner_row).masked_fill(contacts.on_ground, 0.0);
  const Tensor shares = share(torch::cat({tokens, objects.index_select(0, contacts.row), partner}, -1));
  // [C, over and beyond, normal and tangent, linear and angular]
  const Tensor w = shares.reshape({-1, 2, 2, 2, 1, 1});
  const Tensor parts = torch::stack({linear_at_anchors(contacts), angular_at_anchors(contacts)}, 2);  // [C, 2, 2, A, 3]
  const Tensor change = (w * parts.unsqueeze(1)).sum({2, 3});                                         // [C, 2, A, 3]
  return sum_per_object(change.transpose(1, 2).flatten(2), contacts.row, B * K).unflatten(0, {B, K});
}

}  // namespace rigidformer
