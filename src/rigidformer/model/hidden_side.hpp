// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/layers.hpp"

namespace rigidformer {

/// Guesses the side of an object that no camera sees. Every seen point moves to its mirror image through the centre of
/// mass, and from there by an offset that a small PointNet reads off the whole cloud; untrained, it only mirrors. Only
/// the convex hull of seen and guessed points matters: where all sides are seen, guesses belong inside. This goes
/// beyond the paper, which masks random points but never a whole side.
struct HiddenSideHeadImpl : torch::nn::Module {
  HiddenSideHeadImpl();

  /// Maps points [B, K, N, 3] in world orientation and the centre of mass [B, K, 3] to one guess per point,
  /// [B, K, N, 3], in the same frame.
  Tensor forward(const Tensor& points, const Tensor& point_mask, const Tensor& centre);

  Linear layer1{nullptr}, layer2{nullptr}, layer3{nullptr};
  Linear cloud_code{nullptr}, point_code{nullptr};
  Mlp offset{nullptr};
};
TORCH_MODULE(HiddenSideHead);

}  // namespace rigidformer
