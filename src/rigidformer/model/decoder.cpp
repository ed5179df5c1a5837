// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/decoder.hpp"

namespace rigidformer {
namespace {

constexpr std::int64_t kSublayersPerBlock = 2;  // attention and feed-forward (§3.1)
constexpr double kNewestSummaryBias = 4.0;  // starts near the ordinary residual stream, see docs/paper_map.md; by eye

/// Appends the registers, which are always valid and have angle zero.
TokenSet with_registers(const TokenSet& objects, const Tensor& registers) {
  const std::int64_t B = objects.tokens.size(0), R = registers.size(0);
  TokenSet all;
  const Tensor expanded = registers.to(objects.tokens.scalar_type()).unsqueeze(0).expand({B, R, registers.size(1)});
  all.tokens = torch::cat({objects.tokens, expanded}, 1);
  all.mask = torch::cat({objects.mask, torch::ones({B, R}, objects.mask.options())}, 1);
  if (objects.angles.defined()) {
    all.angles =
        torch::cat({objects.angles, torch::zeros({B, R, objects.angles.size(2)}, objects.angles.options())}, 1);
  }
  return all;
}

}  // namespace

DecoderBlockImpl::DecoderBlockImpl(const ModelOptions& options, std::int64_t code_dim) {
  const std::int64_t D = options.embedding_dim;
  attention_norm = register_module("attention_norm", RmsNorm(D));
  attention = register_module("attention", GatedAttention(options));
  film = register_module("film", Film(code_dim, options.film_hidden, D));
  ffn_norm = register_module("ffn_norm", RmsNorm(D));
  ffn = register_module("ffn", SwiGlu(D, options.ffn_expansion, options.dropout));
}

Tensor DecoderBlockImpl::forward(const TokenSet& z, const Tensor& code) {
  const TokenSet normed{attention_norm(z.tokens), z.mask, z.angles};
  const Tensor z_tilde = attention(normed, normed) + z.tokens;
  const Tensor z_hat = film(z_tilde, code);
  return ffn(ffn_norm(z_hat)) + z_hat;
}

BlockResidualImpl::BlockResidualImpl(std::int64_t dim, std::int64_t num_summaries) {
  norm = register_module("norm", RmsNorm(dim));
  score = register_module("score", Linear(dim, 1, false));
  score->zero();
  Tensor start = torch::zeros({num_summaries});
  start[num_summaries - 1] = kNewestSummaryBias;
  bias = register_parameter("bias", start);
}

Tensor BlockResidualImpl::forward(const std::vector<Tensor>& summaries) {
  const Tensor stacked = torch::stack(summaries, -2);                                       // [B, T, S, D]
  const Tensor scores = score(norm(stacked)).squeeze(-1) + bias.to(stacked.scalar_type());  // [B, T, S]
  return (torch::softmax(scores, -1).unsqueeze(-1) * stacked).sum(-2);
}

ObjectDecoderImpl::ObjectDecoderImpl(const ModelOptions& options, std::int64_t code_dim)
    : blocks_per_summary(options.block_residual_size / kSublayersPerBlock) {
  registers = register_parameter("registers", 0.02 * torch::randn({options.num_registers, options.embedding_dim}));
  for (std::int64_t layer = 0; layer < options.num_layers; ++layer) {
    blocks->push_back(DecoderBlock(options, code_dim));
    const bool ends_summary = blocks_per_summary > 0 && (layer + 1) % blocks_per_summary == 0;
    if (ends_summary) {
      residuals->push_back(BlockResidual(options.embedding_dim, (layer + 1) / blocks_per_summary + 1));
    }
  }
  register_module("blocks", blocks);
  register_module("residuals", residuals);
}

std::vector<Tensor> ObjectDecoderImpl::forward(const TokenSet& objects, const Tensor& code) {
  const std::int64_t K = objects.tokens.size(1);
  TokenSet z = with_registers(objects, registers);
  std::vector<Tensor> outputs = {objects.tokens};  // Z^(0)
  std::vector<Tensor> summaries = {z.tokens};
  for (size_t layer = 0; layer < blocks->size(); ++layer) {
    z.tokens = blocks[layer]->as<DecoderBlock>()->forward(z, code);
    if (blocks_per_summary > 0 && (layer + 1) % blocks_per_summary == 0) {
      summaries.push_back(z.tokens);
      z.tokens = residuals[summaries.size() - 2]->as<BlockResidual>()->forward(summaries);
    }
    outputs.push_back(z.tokens.slice(1, 0, K));
  }
  return outputs;
}

}  // namespace rigidformer
