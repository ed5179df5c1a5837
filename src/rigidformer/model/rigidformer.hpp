// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "rigidformer/model/anchor_predictor.hpp"
#include "rigidformer/model/anchor_vertex_pooling.hpp"
#include "rigidformer/model/base_motion.hpp"
#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/centre_of_mass.hpp"
#include "rigidformer/model/contact_tokens.hpp"
#include "rigidformer/model/decoder.hpp"
#include "rigidformer/model/encoder.hpp"
#include "rigidformer/model/hidden_side.hpp"
#include "rigidformer/model/position_encoding.hpp"

namespace rigidformer {

/// The outcome of one step: everything that the losses of §3.4 need.
struct StepPrediction {
  Tensor anchors_raw;  ///< [B, K, A, 3] candidate anchors before rigid projection
  Pose pose;           ///< Projected pose of the reference cloud at t + 1
  Pose departure;      ///< Pose at t from which free motion arrives at `pose` with the velocity predicted there
};

/// The network of §3: it takes two states and a step size, and gives the next rigid state.
struct RigidFormerImpl : torch::nn::Module {
  explicit RigidFormerImpl(const ModelOptions& options);

  /// Centre of mass of every object in its reference frame, [B, K, 3]; needed once per rollout.
  Tensor centre_of_mass(const SceneBatch& batch, const Pose& current);

  /// Points [B, K, P, 3] in the reference frame on the sides that nobody sees, for SceneBatch::hidden_points; undefined
  /// without hidden_side_head. Needed once per rollout.
  Tensor hidden_side(const SceneBatch& batch, const Pose& current, const Tensor& centre_reference);

  /// Predicts one step. centre_reference comes from centre_of_mass(); models with engine_motion need `engine_step`,
  /// those with contact_tokens `contact_search`.
  StepPrediction forward(const SceneBatch& batch, const SceneState& state, const Tensor& centre_reference,
                         const NearestSearch& nearest_search, const EngineStep& engine_step = {},
                         const ContactSearch& contact_search = {});

  /// Type of the activations inside encoder, decoder and predictor: torch::kFloat32 (default), kFloat64 or kBFloat16.
  /// Geometry (poses, Verlet, Kabsch) always stays in the type of the input.
  void set_compute_type(torch::ScalarType type) { compute_type = type; }

  ModelOptions options;
  std::optional<double> fixed_engine_share;  ///< Replaces the learned share: 0 = network alone, 1 = engine alone
  torch::ScalarType compute_type = torch::kFloat32;
  CentreOfMassHead centre_of_mass_head{nullptr};
  HiddenSideHead hidden_side_head{nullptr};
  PointEncoder encoder{nullptr};
  TokenPositionEncoder position_encoder{nullptr};
  ObjectDecoder decoder{nullptr};
  AnchorVertexPooling anchor_vertex_pooling{nullptr};
  AnchorPredictor predictor{nullptr};
  ContactTokens contact_tokens{nullptr};

 private:
  /// How the anchors [B, K, A, 3] deviate from the base motion [m].
  struct AnchorDeviation {
    Tensor over_step;  ///< Deviation of the displacement during the step
    Tensor beyond;     ///< What a step with the velocity at its end has beyond over_step; undefined without that output
  };

  Tensor predict_anchor_outputs(const SceneBatch& batch, const SceneState& state, const BaseMotion& base,
                                const Tensor& points_world, const Nearest& nearest,
                                const std::vector<EngineMotion>& advice, const Contacts& contacts);
  Tensor engine_shares(const Tensor& outputs) const;
  AnchorDeviation deviation_of(const SceneBatch& batch, const Tensor& outputs) const;
  void mix_with_engine(const SceneBatch& batch, const SceneState& state, const BaseMotion& base,
                       const std::vector<EngineMotion>& advice, const Tensor& shares, AnchorDeviation& deviation) const;
  void close_contact_gate(const SceneBatch& batch, const BaseMotion& base, const Tensor& points_world,
                          AnchorDeviation& deviation) const;
};
TORCH_MODULE(RigidFormer);

/// The state after a step. Its two poses carry the predicted velocity; without that output, the current pose becomes
/// the previous one. Objects whose motion is given (static, kinematic) go to coming_pose().
SceneState advance(const SceneBatch& batch, const SceneState& state, const StepPrediction& prediction);

/// Total number of trainable parameters.
std::int64_t count_parameters(const torch::nn::Module& module);

}  // namespace rigidformer
