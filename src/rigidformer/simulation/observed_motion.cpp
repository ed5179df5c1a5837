// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "observed_motion.hpp"

#include <algorithm>
#include <cmath>

#include "rigidformer/scene/mean_material.hpp"

namespace rigidformer {
namespace {

constexpr double kSolverRate_hz = 240.0;  // the frames of the MOVi scenes

}  // namespace

BulletSettings observed_world(double time_step_s, double gravity, const GroundProperties& ground) {
  BulletSettings settings;
  settings.frame_rate_hz = 1.0 / time_step_s;
  settings.substeps = std::max(1, static_cast<int>(std::lround(kSolverRate_hz * time_step_s)));
  settings.gravity = {0.0, 0.0, gravity};
  settings.floor_friction = ground.friction.value_or(kGroundFriction);
  settings.floor_restitution = ground.restitution.value_or(kGroundRestitution);
  return settings;
}

BodyState mean_motion(const RigidTransform& T_ground_before, const RigidTransform& T_ground_now, double time_step_s) {
  BodyState state;
  state.T_world_object = T_ground_now;
  state.velocity = (T_ground_now.translation - T_ground_before.translation) / time_step_s;
  state.angular_velocity = rotation_vector(T_ground_now.rotation * T_ground_before.rotation.conjugate()) / time_step_s;
  return state;
}

double half_fall(double time_step_s, double gravity) { return 0.5 * gravity * time_step_s; }

bool touches_floor(const Points& points_body, const RigidTransform& T_ground_body) {
  return T_ground_body.apply(points_body).col(2).minCoeff() < kTouching_m;
}

BodyProperties with_means(const BodyProperties& known, double volume_m3) {
  return {known.mass_kg.value_or(kMeanDensity * volume_m3), known.friction.value_or(kMeanFriction),
          known.restitution.value_or(kMeanRestitution)};
}

}  // namespace rigidformer
