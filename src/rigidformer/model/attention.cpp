// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/attention.hpp"

#include <cmath>

#include "rigidformer/model/position_encoding.hpp"

namespace rigidformer {

GatedAttentionImpl::GatedAttentionImpl(const ModelOptions& options)
    : num_heads(options.num_heads), head_dim(options.head_dim) {
  const std::int64_t D = options.embedding_dim, width = num_heads * head_dim;
  to_query = register_module("to_query", Linear(D, width, false));
  to_key = register_module("to_key", Linear(D, width, false));
  to_value = register_module("to_value", Linear(D, width, false));
  if (options.gated_attention) to_gate = register_module("to_gate", Linear(D, width));
  to_output = register_module("to_output", Linear(width, D, false));
  query_norm = register_module("query_norm", RmsNorm(head_dim));
  key_norm = register_module("key_norm", RmsNorm(head_dim));
  drop = register_module("drop", torch::nn::Dropout(options.dropout));
}

Tensor GatedAttentionImpl::forward(const TokenSet& query, const TokenSet& key) {
  const auto split_heads = [this](const Tensor& x) { return x.unflatten(-1, {num_heads, head_dim}).transpose(1, 2); };
  Tensor q = query_norm(split_heads(to_query(query.tokens)));  // [B, H, T, head_dim]
  Tensor k = key_norm(split_heads(to_key(key.tokens)));
  const Tensor v = split_heads(to_value(key.tokens));
  if (query.angles.defined()) q = apply_rotary(q, query.angles);
  if (key.angles.defined()) k = apply_rotary(k, key.angles);

  Tensor scores = torch::matmul(q, k.transpose(-1, -2)) / std::sqrt(static_cast<double>(head_dim));
  if (key.mask.defined()) {
    scores = scores.masked_fill(key.mask.logical_not().unsqueeze(1).unsqueeze(1), -1e9);
  }
  const Tensor weights = drop(torch::softmax(scores, -1));
  Tensor y = torch::matmul(weights, v).transpose(1, 2).flatten(-2);  // [B, T, H * head_dim]
  if (!to_gate.is_empty()) y = torch::sigmoid(to_gate(query.tokens)) * y;
  return to_output(y);
}

}  // namespace rigidformer
