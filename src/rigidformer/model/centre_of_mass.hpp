// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/layers.hpp"

namespace rigidformer {

/// Mean of the valid points, [B, K, 3], for points [B, K, N, 3].
Tensor centroid(const Tensor& points, const Tensor& point_mask);

/// Largest distance of a valid point from `centre` [B, K, 3]: bounding radius [B, K] in m.
Tensor bounding_radius(const Tensor& points, const Tensor& point_mask, const Tensor& centre);

/// Number of points of a cloud, the first in farthest-point order, that the heads look at which estimate what an object
/// is: the features that they pool are then alike for clouds of any density. Measured in docs/experiments.md.
constexpr std::int64_t kShapePoints = 96;

/// Estimates where the centre of mass lies inside a cloud that may be partial: a small PointNet on the
/// cloud in units of its own radius, so that the estimate scales with the object. This goes beyond the
/// paper, which needs complete clouds.
struct CentreOfMassHeadImpl : torch::nn::Module {
  CentreOfMassHeadImpl();

  /// Maps points [B, K, N, 3] in world orientation to the centre [B, K, 3] in the same frame.
  Tensor forward(const Tensor& points, const Tensor& point_mask);

  Linear layer1{nullptr}, layer2{nullptr}, layer3{nullptr};
  Mlp output{nullptr};
};
TORCH_MODULE(CentreOfMassHead);

}  // namespace rigidformer
