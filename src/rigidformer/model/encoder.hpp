// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/layers.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// The encoder's view of each object.
struct Encoding {
  Tensor tokens;           ///< [B, K, D]
  Tensor vertex_features;  ///< [B, K, N, E] features f of the backbone, for anchor-vertex pooling
};

/// Hierarchical PointNet (§3.1): a shared point MLP, max-pooled over 100, 50, 25 and 12.5 % of the points in
/// farthest-point order. The four levels are fused into one object token.
struct PointEncoderImpl : torch::nn::Module {
  explicit PointEncoderImpl(const ModelOptions& options);

  /// Encodes features [B, K, N, F] in farthest-point order with point_mask [B, K, N].
  Encoding forward(const Tensor& features, const Tensor& point_mask);

  torch::nn::ModuleList backbone, level_mlps;
  Mlp fuse{nullptr};
};
TORCH_MODULE(PointEncoder);

}  // namespace rigidformer
