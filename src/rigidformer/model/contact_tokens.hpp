// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/base_motion.hpp"
#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/layers.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// What the two unit answers to a contact would do to the own body. The first stops the approach along the normal, the
/// second stops the sliding along the tangent plane, each by one impulse at the contact and as if it were the only one.
struct UnitAnswers {
  Tensor linear;   ///< [C, 2, 3] change of the centre's velocity [m/s]
  Tensor angular;  ///< [C, 2, 3] change of the spin [rad/s]
};

/// Contacts as the network reads them. The geometry comes from a search, in which no gradients flow; velocities come
/// from the state, with gradients.
struct ContactDescription {
  Tensor row, partner_row;  ///< [C] index into the B * K objects; the ground has the own one
  Tensor on_ground;         ///< [C, 1] bool
  Tensor features;          ///< [C, num_token_features] numbers that no rotation about the vertical changes
  UnitAnswers answers;
  Tensor arms;  ///< [C, A, 3] m, the own anchors seen from the own centre of mass, world axes
};

/// Number of features per contact. What the ground is made of comes last, where the model reads it.
std::int64_t num_token_features(const ModelOptions& options);

ContactDescription describe_contacts(const ModelOptions& options, const SceneBatch& batch, const SceneState& state,
                                     const BaseMotion& base, const Contacts& contacts);

/// One token per contact and side. Where and when surfaces meet is computed; what follows from it is learned: a share
/// of each unit answer, for the displacement over the step and for the velocity after it. The share of an answer's
/// linear and of its angular part differ, because the bodies' true inertia is not known.
struct ContactTokensImpl : torch::nn::Module {
  explicit ContactTokensImpl(const ModelOptions& options);

  /// Tokens [C, E].
  Tensor embed(const ContactDescription& contacts);

  /// What the objects learn of their contacts, to be added to their tokens [B, K, D].
  Tensor to_objects(const Tensor& tokens, const ContactDescription& contacts, const Tensor& object_tokens);

  /// What the anchors learn of them: the unit answers there, summed over contacts, [B, K, A, 6] without a unit.
  static Tensor to_anchors(const ContactDescription& contacts, std::int64_t B, std::int64_t K);

  /// Changes of the anchors' motion [B, K, A, 6] in m/s: on average over the step (3), and what the end of the step has
  /// beyond that (3). The decoder's output is [B, K, D].
  Tensor answer(const Tensor& tokens, const ContactDescription& contacts, const Tensor& decoder_output);

  Mlp embedding{nullptr};
  Linear object_part{nullptr};
  Mlp share{nullptr};
};
TORCH_MODULE(ContactTokens);

constexpr std::int64_t kContactAnchorFeatures = 6;

}  // namespace rigidformer
