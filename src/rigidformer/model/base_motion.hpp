// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// The motion of everything during the next step if nothing touched it.
struct BaseMotion {
  bool inertial = false;
  Pose pose;     ///< With inertial base motion: pose of the reference cloud at t + 1 in free rigid motion
  Pose current;  ///< With Verlet: every point continues on its own straight line 2 x_t - x_{t-1}
  Pose previous;
  Pose given;           ///< At t + 1 where the motion is given
  Tensor dynamic_mask;  ///< [B, K] bool, false = the motion is given
  Tensor centre;        ///< [B, K, 3] centre of mass at t in world
  Tensor centre_step;   ///< [B, K, 3] displacement of the centre of mass during the step

  /// Positions at t + 1, by the base motion, of points [B, K, *, 3] given in the reference frame.
  Tensor apply(const Tensor& points_reference) const;
};

/// Makes the base motion; centre_reference [B, K, 3] is the centre of mass in the reference frame. The inertial one has
/// constant spin about that centre, which moves on a parabola under gravity. The other one is the paper's Verlet lines.
/// Objects whose motion is given go to coming_pose() in both.
BaseMotion make_base_motion(const ModelOptions& options, const SceneBatch& batch, const SceneState& state,
                            const Tensor& centre_reference);

/// Tells which objects can touch anything during the step, [B, K] bool: those whose bounding spheres, of radius [B, K]
/// around the centres of mass and swept along the base motion, come within the margin of each other or of the ground.
/// The answer is symmetric per pair.
Tensor contact_gate(const SceneBatch& batch, const BaseMotion& base, const Tensor& radius, double margin_m);

}  // namespace rigidformer
