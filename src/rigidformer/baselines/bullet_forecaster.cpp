// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/bullet_forecaster.hpp"

#include "rigidformer/evaluation/given_poses.hpp"
#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {

std::vector<std::vector<RigidTransform>> BulletForecaster::forecast(const std::vector<ObjectState>& objects,
                                                                    const RolloutOptions& rollout,
                                                                    const std::vector<GivenTrack>& tracks) {
  const std::vector<ObservedBody> bodies = observe_bodies(objects, rollout, decompose_);
  const BulletSettings settings = observed_world(rollout.time_step_s, rollout.gravity, rollout.ground);
  BulletWorld world(settings);
  std::vector<std::vector<RigidTransform>> poses;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    // Bullet moves bodies by the velocity after the kick of gravity: starting half a kick back makes free flight exact.
    BodyState state = bodies[i].state;
    const Shape shape{objects[i].id, 1.0, bodies[i].parts};
    poses.push_back({objects[i].T_world_current});
    if (bodies[i].is_given) {
      poses[i] = given_poses(objects[i], rollout, tracks);
      const int body = world.add_driven_body(shape, 1.0, bodies[i].properties, state);
      world.follow(body, given_path(bodies[i], poses[i], rollout));
    } else {
      state.velocity.z() -= half_fall(rollout.time_step_s, rollout.gravity) / settings.substeps;
      world.add_body(shape, 1.0, bodies[i].properties, state);
    }
  }
  for (int k = 0; k < rollout.num_steps; ++k) {
    world.step_frame();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].is_given) continue;
      poses[i].push_back(reference_pose(bodies[i], world.state(static_cast<int>(i)).T_world_object, rollout));
    }
  }
  return poses;
}

}  // namespace rigidformer
