// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/mujoco_forecaster.hpp"

#include "rigidformer/baselines/observed_body.hpp"
#include "rigidformer/evaluation/given_poses.hpp"
#include "rigidformer/scene/mean_material.hpp"
#include "rigidformer/simulation/mujoco_world.hpp"
#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {
namespace {

MujocoSettings settings_for(const RolloutOptions& rollout) {
  MujocoSettings settings;
  settings.frame_rate_hz = 1.0 / rollout.time_step_s;
  settings.substeps *= observed_world(rollout.time_step_s, rollout.gravity, rollout.ground).substeps;
  settings.gravity = {0.0, 0.0, rollout.gravity};
  settings.floor_friction = rollout.ground.friction.value_or(kGroundFriction);
  settings.floor_restitution = rollout.ground.restitution.value_or(kGroundRestitution);
  return settings;
}

MujocoBody to_mujoco(const ObservedBody& observed, const MujocoSettings& settings) {
  MujocoBody body{observed.parts, observed.properties, observed.state};
  // MuJoCo moves by the velocity after the kick of gravity: starting half a kick back makes free flight exact.
  body.state.velocity -= 0.5 / (settings.frame_rate_hz * settings.substeps) * settings.gravity;
  return body;
}

}  // namespace

std::vector<std::vector<RigidTransform>> MujocoForecaster::forecast(const std::vector<ObjectState>& objects,
                                                                    const RolloutOptions& rollout,
                                                                    const std::vector<GivenTrack>& tracks) {
  const std::vector<ObservedBody> observed = observe_bodies(objects, rollout);
  const MujocoSettings settings = settings_for(rollout);
  std::vector<MujocoBody> bodies;
  std::vector<std::vector<RigidTransform>> poses;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    bodies.push_back(to_mujoco(observed[i], settings));
    poses.push_back({objects[i].T_world_current});
    if (!observed[i].is_given) continue;
    poses[i] = given_poses(objects[i], rollout, tracks);
    bodies[i].is_static = objects[i].mode == MotionMode::kStatic;
    if (!bodies[i].is_static) bodies[i].path = given_path(observed[i], poses[i], rollout);
  }
  MujocoWorld world(settings, bodies);
  world.accept_overlaps();
  for (int k = 0; k < rollout.num_steps; ++k) {
    world.step_frame();
    for (std::size_t i = 0; i < observed.size(); ++i) {
      if (observed[i].is_given) continue;
      const RigidTransform T_ground_body = world.state(static_cast<int>(i)).T_world_object;
      poses[i].push_back(world.has_diverged() ? poses[i].back() : reference_pose(observed[i], T_ground_body, rollout));
    }
  }
  return poses;
}

}  // namespace rigidformer
