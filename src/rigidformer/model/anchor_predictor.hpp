// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/model/anchor_vertex_pooling.hpp"
#include "rigidformer/model/attention.hpp"

namespace rigidformer {

/// One cross-attention layer of the predictor: anchors read the object tokens of one decoder output.
struct CrossAttentionLayerImpl : torch::nn::Module {
  explicit CrossAttentionLayerImpl(const ModelOptions& options);

  /// Attends with query [B, K * A, D] to key [B, K, D].
  Tensor forward(const TokenSet& query, const TokenSet& key);

  RmsNorm query_norm{nullptr}, key_norm{nullptr}, ffn_norm{nullptr};
  GatedAttention attention{nullptr};
  SwiGlu ffn{nullptr};
};
TORCH_MODULE(CrossAttentionLayer);

/// Number of values per anchor: the change of motion over the step (3), what the velocity at its end has beyond that
/// (3), and the logit of the share that the engine's step has in both (1), each where the options ask for it.
std::int64_t num_anchor_outputs(const ModelOptions& options);

/// Turns anchor queries into outputs (§3.2, App. G). Anchor state and pooled vertex features make a query, which reads
/// the object tokens of several decoder outputs in parallel. The reads are fused, and a head makes the outputs.
struct AnchorPredictorImpl : torch::nn::Module {
  explicit AnchorPredictorImpl(const ModelOptions& options);

  /// `anchor_state` is [B, K, A, F + 3 + avp_dim + engine features]. `keys` are the decoder outputs Z^(0..L) with mask
  /// and object angles. anchor_angles [B, K, A, rotary_dim] and anchor_embedding [B, K, A or 1, D] may be undefined.
  /// Returns [B, K, A, num_anchor_outputs()].
  Tensor forward(const Tensor& anchor_state, const std::vector<Tensor>& decoder_outputs, const TokenSet& objects,
                 const Tensor& anchor_angles, const Tensor& anchor_embedding);

  ModelOptions options;
  Mlp to_query{nullptr};
  Linear own_token{nullptr};
  torch::nn::ModuleList layers;  ///< Layers in the order of the scales: scales x layers per scale
  Linear fuse{nullptr};
  RmsNorm head_norm{nullptr};
  Mlp head{nullptr};
};
TORCH_MODULE(AnchorPredictor);

}  // namespace rigidformer
