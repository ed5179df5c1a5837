// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"

namespace rigidformer {

/// Rotation R = V diag(1, 1, det(V U^T)) U^T of the SVD H = U S V^T (§3.2), for H [..., 3, 3]. The backward pass uses
/// the closed form of the special orthogonal Procrustes problem. Its denominators are sums of singular values, the last
/// one signed by the determinant: they stay finite when singular values coincide and when anchors lie in a plane.
Tensor special_procrustes(const Tensor& H);

/// Rigid transform that best maps source [B, K, A, 3] to target [B, K, A, 3] in the least-squares sense (Kabsch's
/// method). With `differentiable` false the transform counts as a constant.
Pose align_rigidly(const Tensor& source, const Tensor& target, bool differentiable = true);

}  // namespace rigidformer
