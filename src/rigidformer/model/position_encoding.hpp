// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// Rotary angles and additive embeddings that tell attention where tokens are. Either part may be undefined.
struct TokenPositions {
  Tensor object_angles;     ///< [B, K, rotary_dim]
  Tensor anchor_angles;     ///< [B, K, A, rotary_dim]
  Tensor object_embedding;  ///< [B, K, D]
  Tensor anchor_embedding;  ///< [B, K, A, D]
};

/// Rotary angles psi_omega of Eq. (1): each coordinate of positions [..., 3] times log-spaced frequencies,
/// listed twice -> [..., rotary_dim].
Tensor rotary_angles(const Tensor& positions, std::int64_t rotary_dim);

/// Rotates the first channels of x [B, H, T, head_dim] by angles [B, T, rotary_dim] (§3.3); the rest passes through.
Tensor apply_rotary(const Tensor& x, const Tensor& angles);

/// All encodings of Tab. 7 behind one interface. ARoPE needs no parameters. The sinusoidal encoding embeds the
/// positions of centroid and anchors, the learned one the object's index; obb, pca and se3 embed box, principal
/// axes or pose with a small network.
struct TokenPositionEncoderImpl : torch::nn::Module {
  explicit TokenPositionEncoderImpl(const ModelOptions& options);

  /// Encodes anchors_world [B, K, A, 3] and points_world [B, K, N, 3].
  TokenPositions forward(const SceneBatch& batch, const Pose& current, const Tensor& points_world,
                         const Tensor& anchors_world);

  ModelOptions options;
  torch::nn::Sequential embed{nullptr};
  Tensor table;
};
TORCH_MODULE(TokenPositionEncoder);

}  // namespace rigidformer
