// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/model/anchors.hpp"
#include "rigidformer/model/batch.hpp"
#include "rigidformer/windows/scene_tensors.hpp"
#include "rigidformer/windows/tensor_random.hpp"
#include "rigidformer/windows/window_sampler.hpp"

namespace rigidformer {

/// How a scene is observed and varied. Field names are the YAML keys under `augmentation:`.
struct AugmentationOptions {
  int min_points = 64;                   ///< Fewest points per object; the number is drawn per object
  int max_points = 128;                  ///< Most points per object, and the padded size
  double vertex_probability = 0.0;       ///< Share of windows that use mesh vertices instead of surface samples
  double view_probability = 0.0;         ///< Share of windows that keep only points facing one random camera
  double noise_m = 0.0;                  ///< Largest standard deviation of point noise, drawn per window
  double unknown_probability = 0.0;      ///< Share of windows whose material parameters are hidden
  double yaw_probability = 0.5;          ///< Share of windows turned about the vertical axis (paper, App. E)
  double yaw_step_deg = 5.0;             ///< Windows are turned by multiples of this angle; 0 = by any angle
  bool yaw_per_batch = true;             ///< One angle for the whole batch (paper, App. E), or one per window
  double shift_m = 0.0;                  ///< Windows are moved horizontally by up to this distance
  double permutation_probability = 0.5;  ///< Share of windows with objects in random order (paper, App. E)
};

/// A batch of windows with ground truth. The reference frame of every cloud is the body frame, so that the true centre
/// of mass is the origin of the reference frame.
struct WindowBatch {
  SceneBatch scene;
  std::vector<Pose> poses;  ///< 2 + num_steps poses; the first two are given
  /// [step] poses from which free motion arrives at the step's end with the true velocity there.
  std::vector<Pose> departures;
  Tensor whole_surface;  ///< [B, K, M, 3] m, without noise and with the sides that nobody sees
  Tensor whole_mask;     ///< [B, K, M] bool
};

/// Assembles windows on the device of `tensors`; a generator of `random` must live there too.
WindowBatch make_window_batch(const SceneTensors& tensors, const std::vector<Window>& windows, int num_steps,
                              int num_anchors, const AugmentationOptions& options, bool random_anchors = false,
                              const TensorRandom& random = {});

/// The settings for scoring: surface samples, no augmentation.
AugmentationOptions no_augmentation(int num_points);

}  // namespace rigidformer
