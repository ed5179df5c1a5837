// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/evaluation/forecaster.hpp"

namespace rigidformer {

/// MuJoCo, given what the network sees (see observed_body.hpp): convex meshes with elliptic friction cones and sixteen
/// solver steps per 240 Hz frame. MuJoCo has no coefficient of restitution. Every pair of bodies gets a spring and
/// damper that rebound with the product of the two coefficients (see contact_spring.hpp), and the product of the two
/// frictions, as in Bullet. Hulls that overlap at the start may keep that overlap.
class MujocoForecaster : public Forecaster {
 public:
  std::string name() const override { return "mujoco"; }

  /// Objects keep their last pose once the simulation stops being finite. Throws std::invalid_argument for what
  /// observe_bodies() refuses, and std::runtime_error with MuJoCo's words when it refuses the scene.
  std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                    const RolloutOptions& rollout,
                                                    const std::vector<GivenTrack>& tracks = {}) override;
};

}  // namespace rigidformer
