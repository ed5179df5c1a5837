// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// Where everything would go during the next step if nothing touched it.
struct BaseMotion {
  bool inertial = false;
  Pose pose;     ///< Inertial: pose of the reference cloud at t + 1 in free rigid motion
  Pose current;  ///< Verlet: every point continues on its own straight line 2 x_t - x_{t-1}
  Pose previous;
  Tensor centre;       ///< [B, K, 3] centre of mass at t, world
  Tensor centre_step;  ///< [B, K, 3] its displacement during the step

  /// Base positions at t + 1 of points [B, K, *, 3] given in the reference frame.
  Tensor apply(const Tensor& points_reference) const;
};

/// centre_reference [B, K, 3]: centre of mass in the reference frame. Inertial: constant spin about it and a parabola
/// under gravity. Otherwise the paper's Verlet lines.
BaseMotion make_base_motion(const ModelOptions& options, const SceneBatch& batch, const SceneState& state,
                            const Tensor& centre_reference);

/// Which objects can touch anything during the step, [B, K] bool: bounding spheres of radius [B, K] around the centres
/// of mass, swept along the base motion, come within the margin of each other or of the ground. Symmetric per pair.
Tensor contact_gate(const SceneBatch& batch, const BaseMotion& base, const Tensor& radius, double margin_m);

}  // namespace rigidformer
