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

Tensor DecoderBlockImpl::attention_update(const TokenSet& z) {
  const TokenSet normed{attention_norm(z.tokens), z.mask, z.angles};
  return attention(normed, normed);
}

Tensor DecoderBlockImpl::feed_forward(const Tensor& z_tilde, const Tensor& code) {
  const Tensor z_hat = film(z_tilde, code);
  return ffn(ffn_norm(z_hat)) + z_hat;
}

Tensor DecoderBlockImpl::forward(const TokenSet& z, const Tensor& code) {
  return feed_forward(attention_update(z) + z.tokens, code);
}

AttentionResidualImpl::AttentionResidualImpl(std::int64_t dim) {
  norm = register_module("norm", RmsNorm(dim));
  query = register_module("query", Linear(dim, 1, false));
  query->zero();
}

Tensor AttentionResidualImpl::forward(const std::vector<Tensor>& sources) {
  const Tensor stacked = torch::stack(sources, -2);  // [B, T, S, D]
  const Tensor weights = torch::softmax(query(norm(stacked)).squeeze(-1), -1);
  return (weights.unsqueeze(-1) * stacked).sum(-2);
}

BlockSums::BlockSums(const Tensor& embedding, std::int64_t sublayers_per_block)
    : sublayers_per_block_(sublayers_per_block), finished_{embedding} {}

void BlockSums::add(const Tensor& update) {
  partial_ = partial_.defined() ? partial_ + update : update;
  if (++sublayers_ % sublayers_per_block_ != 0) return;
  finished_.push_back(partial_);
  partial_ = Tensor();
}

std::vector<Tensor> BlockSums::sources() const {
  std::vector<Tensor> sources = finished_;
  if (partial_.defined()) sources.push_back(partial_);
  return sources;
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
    : sublayers_per_block(options.block_residual_size),
      residual_per_sublayer(options.residual_per_sublayer && options.block_residual_size > 0) {
  registers = register_parameter("registers", 0.02 * torch::randn({options.num_registers, options.embedding_dim}));
  const std::int64_t blocks_per_summary = sublayers_per_block / kSublayersPerBlock;
  for (std::int64_t layer = 0; layer < options.num_layers; ++layer) {
    blocks->push_back(DecoderBlock(options, code_dim));
    if (residual_per_sublayer) continue;
    const bool ends_summary = blocks_per_summary > 0 && (layer + 1) % blocks_per_summary == 0;
    if (ends_summary) {
      residuals->push_back(BlockResidual(options.embedding_dim, (layer + 1) / blocks_per_summary + 1));
    }
  }
  if (residual_per_sublayer) {  // one before every sublayer, and one for what leaves the last
    for (std::int64_t i = 0; i <= kSublayersPerBlock * options.num_layers; ++i) {
      residuals->push_back(AttentionResidual(options.embedding_dim));
    }
  }
  register_module("blocks", blocks);
  register_module("residuals", residuals);
}

std::vector<Tensor> ObjectDecoderImpl::forward(const TokenSet& objects, const Tensor& code) {
  const std::int64_t K = objects.tokens.size(1);
  const TokenSet z = with_registers(objects, registers);
  std::vector<Tensor> outputs = residual_per_sublayer ? forward_per_sublayer(z, code) : forward_per_block(z, code);
  for (Tensor& output : outputs) output = output.slice(1, 0, K);
  return outputs;
}

/// Z^(l) is what enters block l + 1, and Z^(L) what leaves the last one.
std::vector<Tensor> ObjectDecoderImpl::forward_per_sublayer(TokenSet z, const Tensor& code) {
  BlockSums sums(z.tokens, sublayers_per_block);
  auto residual = residuals->begin();
  const auto next_input = [&] { return (*residual++)->as<AttentionResidual>()->forward(sums.sources()); };
  std::vector<Tensor> outputs;
  for (const auto& module : *blocks) {
    auto* block = module->as<DecoderBlock>();
    z.tokens = next_input();
    outputs.push_back(z.tokens);
    sums.add(block->attention_update(z));
    const Tensor z_tilde = next_input();
    sums.add(block->feed_forward(z_tilde, code) - z_tilde);
  }
  outputs.push_back(next_input());
  return outputs;
}

std::vector<Tensor> ObjectDecoderImpl::forward_per_block(TokenSet z, const Tensor& code) {
  std::vector<Tensor> outputs = {z.tokens};  // Z^(0)
  std::vector<Tensor> summaries = {z.tokens};
  const auto blocks_per_summary = static_cast<size_t>(sublayers_per_block / kSublayersPerBlock);
  for (size_t layer = 0; layer < blocks->size(); ++layer) {
    z.tokens = blocks[layer]->as<DecoderBlock>()->forward(z, code);
    if (blocks_per_summary > 0 && (layer + 1) % blocks_per_summary == 0) {
      summaries.push_back(z.tokens);
      z.tokens = residuals[summaries.size() - 2]->as<BlockResidual>()->forward(summaries);
    }
    outputs.push_back(z.tokens);
  }
  return outputs;
}

}  // namespace rigidformer
