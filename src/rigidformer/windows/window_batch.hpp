// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/model/anchors.hpp"
#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/tensor_random.hpp"
#include "rigidformer/windows/options.hpp"
#include "rigidformer/windows/scene_tensors.hpp"
#include "rigidformer/windows/window_sampler.hpp"

namespace rigidformer {

/// A batch of windows with ground truth. The reference frame of every cloud is the body frame, so the true centre of
/// mass is the origin of the reference frame.
struct WindowBatch {
  SceneBatch scene;
  std::vector<Pose> poses;  ///< 2 + num_steps poses; the first two are given
  /// [step] poses from which free motion arrives at the step's end with the true velocity there.
  std::vector<Pose> departures;
  std::vector<Tensor> controls;  ///< [step] commands [B, C] in whose force the step begins; empty = none
  Tensor whole_surface;          ///< [B, K, M, 3] m, without noise and with the sides that nobody sees
  Tensor whole_mask;             ///< [B, K, M] bool
};

/// Assembles windows on the device of `tensors`; a generator of `random` must live there too.
WindowBatch make_window_batch(const SceneTensors& tensors, const std::vector<Window>& windows, int num_steps,
                              int num_anchors, const AugmentationOptions& options, bool random_anchors = false,
                              const TensorRandom& random = {});

constexpr int kAllVertices = 0;  ///< Instead of a number of surface samples

/// The settings for scoring: that many surface samples or kAllVertices, no augmentation.
AugmentationOptions no_augmentation(int num_points);

}  // namespace rigidformer
