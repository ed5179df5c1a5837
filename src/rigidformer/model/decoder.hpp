// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/model/attention.hpp"

namespace rigidformer {

/// One block of §3.1: residual self-attention, FiLM by the step-size code, residual SwiGLU.
struct DecoderBlockImpl : torch::nn::Module {
  DecoderBlockImpl(const ModelOptions& options, std::int64_t code_dim);

  /// Maps tokens [B, T, D] to new tokens [B, T, D].
  Tensor forward(const TokenSet& z, const Tensor& code);

  /// The two sublayers of forward(): what attention adds, and the stream after FiLM and feed-forward.
  Tensor attention_update(const TokenSet& z);
  Tensor feed_forward(const Tensor& z_tilde, const Tensor& code);

  RmsNorm attention_norm{nullptr}, ffn_norm{nullptr};
  GatedAttention attention{nullptr};
  Film film{nullptr};
  SwiGlu ffn{nullptr};
};
TORCH_MODULE(DecoderBlock);

/// Attention residual before one sublayer (ref. [20]): its input is a softmax-weighted mix of what came before, scored
/// by a learned query on the normalised sources. The query starts at zero, that is, with the plain mean.
struct AttentionResidualImpl : torch::nn::Module {
  explicit AttentionResidualImpl(std::int64_t dim);

  /// Mixes sources [B, T, D], at least one.
  Tensor forward(const std::vector<Tensor>& sources);

  RmsNorm norm{nullptr};
  Linear query{nullptr};
};
TORCH_MODULE(AttentionResidual);

/// The sources that attention residuals choose from: the embedding, the sums of what the sublayers of finished blocks
/// added, and the partial sum of the present block.
class BlockSums {
 public:
  BlockSums(const Tensor& embedding, std::int64_t sublayers_per_block);
  void add(const Tensor& update);
  std::vector<Tensor> sources() const;

 private:
  std::int64_t sublayers_per_block_, sublayers_ = 0;
  std::vector<Tensor> finished_;
  Tensor partial_;
};

/// A simpler form, with one mix per block: the stream continues from a softmax-weighted mix of the streams at the ends
/// of all blocks so far. Scores come from a learned vector on the normalised summary plus a bias that starts on the
/// newest summary.
struct BlockResidualImpl : torch::nn::Module {
  BlockResidualImpl(std::int64_t dim, std::int64_t num_summaries);

  /// Mixes the summaries: `num_summaries` tensors [B, T, D], oldest first.
  Tensor forward(const std::vector<Tensor>& summaries);

  RmsNorm norm{nullptr};
  Linear score{nullptr};
  Tensor bias;
};
TORCH_MODULE(BlockResidual);

/// L blocks over object tokens and register tokens; registers have no position.
struct ObjectDecoderImpl : torch::nn::Module {
  ObjectDecoderImpl(const ModelOptions& options, std::int64_t code_dim);

  /// Maps object tokens [B, K, D] to Z^(0) ... Z^(L), each [B, K, D], with the registers left out.
  std::vector<Tensor> forward(const TokenSet& objects, const Tensor& code);

  std::int64_t sublayers_per_block;
  bool residual_per_sublayer;
  Tensor registers;  ///< [R, D]
  torch::nn::ModuleList blocks, residuals;

 private:
  std::vector<Tensor> forward_per_sublayer(TokenSet z, const Tensor& code);
  std::vector<Tensor> forward_per_block(TokenSet z, const Tensor& code);
};
TORCH_MODULE(ObjectDecoder);

}  // namespace rigidformer
