// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/layers.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// Anchor-vertex pooling (§3.2, Eq. 3): u = sum_v w_v f_v / sum_v w_v with w_v = exp(-|x_v - q| / sigma), sigma
/// learned, then a two-layer MLP whose last layer starts at zero (App. G).
struct AnchorVertexPoolingImpl : torch::nn::Module {
  explicit AnchorVertexPoolingImpl(const ModelOptions& options);

  /// Maps f [B, K, N, E], points [B, K, N, 3] and anchors [B, K, A, 3] to [B, K, A, avp_dim].
  Tensor forward(const Tensor& f, const Tensor& points, const Tensor& point_mask, const Tensor& anchors);

  Tensor log_sigma;  ///< Scalar, logarithm of the bandwidth sigma in m
  Mlp mlp{nullptr};
};
TORCH_MODULE(AnchorVertexPooling);

}  // namespace rigidformer
