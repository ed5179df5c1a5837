// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "rigidformer/model/batch.hpp"

namespace rigidformer {

constexpr std::array<double, 4> kLevelFractions = {1.0, 0.5, 0.25, 0.125};  // share of the points in each level (§3.1)

/// The maxima of vertex features f [B, K, N, E] over the first ceil(fraction * n) of each object's n valid points, one
/// [B, K, E] per level. The points of `point_mask` [B, K, N] stand first. Zero for objects without points.
std::array<Tensor, kLevelFractions.size()> pool_levels(const Tensor& f, const Tensor& point_mask);

/// The same from operations of LibTorch alone, which copy f once per level: for GPUs and other types than float32.
std::array<Tensor, kLevelFractions.size()> pool_levels_by_masks(const Tensor& f, const Tensor& point_mask);

}  // namespace rigidformer
