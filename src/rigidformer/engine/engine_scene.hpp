// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pose_table.hpp"
#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/engine/solid_scene.hpp"
#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {

/// The poses of a batch that one step reads and changes.
struct EngineStepPoses {
  PoseTable& previous;
  PoseTable& current;
  const PoseTable& coming;  ///< At t + 1 of what is given (given_motion.hpp)
};

/// One scene of a batch as bodies of a Bullet world, whose floor is the scene's ground.
class EngineScene {
 public:
  /// The bodies `solids` of scene `b` of a batch, which is on the CPU.
  EngineScene(const SceneBatch& batch, std::vector<ObservedSolid> solids, std::int64_t b, Sleep sleep);

  /// Takes the poses one step ahead: `current` to t + 1, `previous` to where free motion departs at t to arrive there
  /// with the velocities that the bodies have.
  void step(const EngineStepPoses& poses);

  /// What pressed on what during the last step.
  std::vector<PressedPair> pressed() const;

 private:
  void add_body(const ObservedSolid& solid);
  /// Which bodies the last step was taken with where they are now, and was undone since: what came of it was held at
  /// rest. The same comes of it again, so long as nothing reaches them.
  std::vector<bool> find_sleepers(const EngineStepPoses& poses);
  void keep_pressed(const std::vector<bool>& asleep);
  std::vector<BodyState> observe(const EngineStepPoses& poses) const;
  std::vector<bool> fall(const std::vector<BodyState>& states) const;
  RigidTransform departure(const BodyState& arrived, bool falls) const;
  double fall_before_step() const;
  RigidTransform on_ground(const ObservedSolid& body, const RigidTransform& T_world_reference) const;
  RigidTransform from_ground(const ObservedSolid& body, RigidTransform T_ground_body) const;

  std::int64_t scene_;
  double time_step_s_, gravity_, ground_height_m_;
  double mass_unit_kg_ = 1.0;
  BulletWorld world_;
  SolidScene bodies_;  ///< With the ground at height 0
  Sleep sleep_;
  std::vector<RigidTransform> T_world_stepped_;  ///< Poses from which the last step was taken
  std::vector<PressedBodies> pressed_;
};

}  // namespace rigidformer
