// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

namespace rigidformer {

using torch::Tensor;

/// Linear layer y = x W^T + b, computed in the type of x: activations decide the precision, weights follow.
struct LinearImpl : torch::nn::Module {
  LinearImpl(std::int64_t in, std::int64_t out, bool with_bias = true);
  Tensor forward(const Tensor& x);

  /// Sets weight and bias to zero, so that the layer starts by contributing nothing.
  void zero();

  Tensor weight, bias;
};
TORCH_MODULE(Linear);

/// Root-mean-square normalisation over the last dimension with a learned scale, computed in float32.
struct RmsNormImpl : torch::nn::Module {
  explicit RmsNormImpl(std::int64_t dim);
  Tensor forward(const Tensor& x);

  Tensor scale;
};
TORCH_MODULE(RmsNorm);

/// Two-layer MLP: Linear, SiLU, Linear.
struct MlpImpl : torch::nn::Module {
  MlpImpl(std::int64_t in, std::int64_t hidden, std::int64_t out, bool zero_last = false);
  Tensor forward(const Tensor& x);

  Linear first{nullptr}, second{nullptr};
};
TORCH_MODULE(Mlp);

/// Feed-forward W3 (silu(W1 x) * W2 x) with hidden width `expansion` * dim (App. G, SwiGLU).
struct SwiGluImpl : torch::nn::Module {
  SwiGluImpl(std::int64_t dim, double expansion, double dropout);
  Tensor forward(const Tensor& x);

  Linear gate_and_value{nullptr}, output{nullptr};
  torch::nn::Dropout drop{nullptr};
};
TORCH_MODULE(SwiGlu);

/// Feature-wise scale and shift from a code c (§3.1): gamma(c) * z + beta(c). It is initialised to the identity.
struct FilmImpl : torch::nn::Module {
  FilmImpl(std::int64_t code_dim, std::int64_t hidden, std::int64_t dim);

  /// Applies the code [B, code_dim] to z [B, T, D].
  Tensor forward(const Tensor& z, const Tensor& code);

  Mlp mlp{nullptr};
};
TORCH_MODULE(Film);

}  // namespace rigidformer
