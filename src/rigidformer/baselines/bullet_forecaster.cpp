// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/bullet_forecaster.hpp"

namespace rigidformer {

std::vector<std::vector<RigidTransform>> BulletForecaster::forecast(const std::vector<ObjectState>& objects,
                                                                    const RolloutOptions& rollout) {
  const std::vector<ObservedBody> bodies = observe_bodies(objects, rollout, decompose_);
  BulletSettings settings;
  settings.frame_rate_hz = 1.0 / rollout.time_step_s;
  settings.substeps = substeps_per_step(rollout);
  settings.gravity = {0.0, 0.0, rollout.gravity};
  BulletWorld world(settings);
  std::vector<std::vector<RigidTransform>> poses;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    // Bullet moves by the velocity after the kick of gravity: starting half a kick back makes free flight exact.
    BodyState state = bodies[i].state;
    if (!bodies[i].is_static) state.velocity -= 0.5 * settings.gravity * rollout.time_step_s / settings.substeps;
    const Shape shape{objects[i].id, 1.0, bodies[i].parts};
    if (bodies[i].is_static) {
      world.add_driven_body(shape, 1.0, bodies[i].properties, state);
    } else {
      world.add_body(shape, 1.0, bodies[i].properties, state);
    }
    poses.push_back({objects[i].T_world_current});
  }
  for (int k = 0; k < rollout.num_steps; ++k) {
    world.step_frame();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      poses[i].push_back(reference_pose(bodies[i], world.state(static_cast<int>(i)).T_world_object, rollout));
    }
  }
  return poses;
}

}  // namespace rigidformer
