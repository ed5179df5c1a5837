// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/layers.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// One side of an attention: tokens, which of them are valid, and their rotary angles (undefined = position zero).
struct TokenSet {
  Tensor tokens;  ///< [B, T, D]
  Tensor mask;    ///< [B, T] bool; undefined = all valid
  Tensor angles;  ///< [B, T, rotary_dim] or undefined
};

/// Multi-head attention with QK-normalisation, rotary positions and a query-conditioned sigmoid gate (§3.1): y =
/// sigmoid(G(Q)) * Attn(Q, K, V). It is self-attention when both arguments are the same set.
struct GatedAttentionImpl : torch::nn::Module {
  explicit GatedAttentionImpl(const ModelOptions& options);

  /// Returns [B, T_query, D]. Rows of invalid queries are meaningless.
  Tensor forward(const TokenSet& query, const TokenSet& key);

  std::int64_t num_heads, head_dim;
  Linear to_query{nullptr}, to_key{nullptr}, to_value{nullptr}, to_gate{nullptr}, to_output{nullptr};
  RmsNorm query_norm{nullptr}, key_norm{nullptr};
  torch::nn::Dropout drop{nullptr};
};
TORCH_MODULE(GatedAttention);

}  // namespace rigidformer
