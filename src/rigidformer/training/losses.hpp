// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/rigidformer.hpp"
#include "rigidformer/training/options.hpp"
#include "rigidformer/windows/window_batch.hpp"

namespace rigidformer {

/// Loss of one predicted step, Eq. (12): lambda_pos (pos raw + pos rigid) + lambda_acc (acc raw + acc rigid), Smooth L1
/// at the anchors, averaged over valid anchors of dynamic objects. `truth` is the true pose at t + 1.
Tensor step_loss(const LossOptions& options, const SceneBatch& batch, const StepPrediction& prediction,
                 const Pose& truth);

/// Smooth L1 of the velocity [m/s] that the anchors have after the step; `departure` is that of WindowBatch.
Tensor end_velocity_loss(const LossOptions& options, const SceneBatch& batch, const StepPrediction& prediction,
                         const Pose& truth, const Pose& departure);

/// Smooth L1 of the estimated centre of mass, in units of the bounding radius; the true centre is the reference origin.
Tensor centre_of_mass_loss(const LossOptions& options, const SceneBatch& batch, const Tensor& centre_reference);

/// Smooth L1 of how far the convex hull of seen and guessed points reaches into random directions, compared with the
/// whole surface, in units of the bounding radius.
Tensor hidden_side_loss(const LossOptions& options, const WindowBatch& windows, const Tensor& hidden_points);

/// Mean loss over all unrolled steps. Gradients flow through the rigid projection from step to step.
Tensor window_loss(const LossOptions& options, RigidFormer& model, const WindowBatch& windows,
                   const NearestSearch& nearest_search);

}  // namespace rigidformer
