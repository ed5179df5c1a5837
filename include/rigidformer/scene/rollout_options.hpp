// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rigidformer/scene/object.hpp"

namespace rigidformer {

/// The scene-wide settings of one rollout.
struct RolloutOptions {
  int num_steps = 10;                 ///< Number of steps, at least 1
  double time_step_s = 10.0 / 240.0;  ///< [s] must lie in the model's trained range
  double gravity = -10.0;  ///< Vertical acceleration [m/s^2]; only models with inertial base motion can change it
  std::optional<double> ground_height_m = 0.0;  ///< Height of the ground plane z = h; empty = no ground
  GroundProperties ground = {};                 ///< What the ground is made of
  /// The command of every step, or one for all: as many numbers each as ModelInfo::control_dim says. Empty = none.
  std::vector<std::vector<double>> control = {};
  int num_particles = 1;            ///< Worlds among which unknown material is drawn; 1 = none but the forecast itself
  std::uint64_t particle_seed = 0;  ///< Of the draws
};

}  // namespace rigidformer
