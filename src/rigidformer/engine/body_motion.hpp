// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/engine/solid_scene.hpp"

/// Two poses hold the mean velocity of the step between them. What is told of an instant (a twist, an impulse) is
/// another velocity where gravity acts freely, and the same where something carries the body.
namespace rigidformer {

/// The bodies of a scene one time step ago and now. Poses have their origin in the centre of mass.
struct BodyPoses {
  std::vector<RigidTransform> before, now;
  double time_step_s = 0.0;
  double gravity = 0.0;  ///< Vertical acceleration [m/s^2]
};

/// How body `body` moves now. All three throw std::runtime_error where Bullet was not there at build time.
BodyState motion_now(const SolidScene& scene, const BodyPoses& poses, int body);

/// Where the body has to have been one time step ago for its poses to say that it moves so now.
RigidTransform departure(const SolidScene& scene, const BodyPoses& poses, int body, const BodyState& motion);

/// The motion after an impulse at a point [m], seen from the centre of mass in world axes. The mass must be real.
BodyState pushed(const ObservedSolid& solid, BodyState motion, const Eigen::Vector3d& impulse_Ns,
                 const Eigen::Vector3d& angular_impulse_Nms, const Eigen::Vector3d& point);

}  // namespace rigidformer
