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

  RmsNorm attention_norm{nullptr}, ffn_norm{nullptr};
  GatedAttention attention{nullptr};
  Film film{nullptr};
  SwiGlu ffn{nullptr};
};
TORCH_MODULE(DecoderBlock);

/// Block attention residual (ref. [20]): the stream continues from a softmax-weighted mix of all block summaries so
/// far. Scores come from a learned vector on the normalised summary plus a bias that starts on the newest summary.
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

  std::int64_t blocks_per_summary;
  Tensor registers;  ///< [R, D]
  torch::nn::ModuleList blocks, residuals;
};
TORCH_MODULE(ObjectDecoder);

}  // namespace rigidformer
