// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"

namespace rigidformer {

/// Chooses anchors by farthest point sampling (§3.2): points [B, K, N, 3] -> indices [B, K, A]. The first anchor is the
/// point farthest from the centroid, or the one of the highest score [B, K, N] (random in Tab. 9). Anchors are distinct
/// as long as the cloud has A distinct points.
Tensor farthest_anchors(const Tensor& points, const Tensor& point_mask, int num_anchors,
                        const Tensor& start_score = {});

}  // namespace rigidformer
