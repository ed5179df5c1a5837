// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pose_table.hpp"
#include "rigidformer/engine/observed_solid.hpp"
#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {

/// One scene of a batch as bodies of a Bullet world, whose floor is the scene's ground.
class EngineScene {
 public:
  /// Scene `b` of the batch; centre_reference [B, K, 3] in double precision; all on the CPU.
  EngineScene(const SceneBatch& batch, const Tensor& centre_reference, std::int64_t b);

  /// Takes the poses one step ahead: `current` to t + 1, `previous` to where free motion departs at t to arrive there
  /// with the velocities that the bodies have. Writes into `certain` [B, K] bool for which objects nothing is guessed.
  void step(PoseTable& previous, PoseTable& current, Tensor& certain);

 private:
  struct Body {
    std::int64_t object = 0;           ///< Index k in the batch
    bool dynamic = true;               ///< Else its motion is given
    Eigen::Vector3d centre_reference;  ///< Centre of mass in the reference frame [m]
    Points hull;                       ///< Vertices relative to the centre of mass [m]
    bool fully_known = false;          ///< Seen from all sides and of known material
  };

  void add_body(const ObservedSolid& solid, double mass_unit_kg);
  BodyState observe(const Body& body, const RigidTransform& before, const RigidTransform& now) const;
  RigidTransform departure(const Body& body, const BodyState& arrived) const;
  double fall_before_step() const;
  bool falls(const Body& body, const BodyState& state) const;
  static bool is_certain(const Body& body, const BodyState& state);
  RigidTransform on_ground(const Body& body, const RigidTransform& T_world_reference) const;
  RigidTransform from_ground(const Body& body, RigidTransform T_ground_body) const;

  std::int64_t scene_;
  double time_step_s_, gravity_, ground_height_m_;
  BulletWorld world_;
  std::vector<Body> bodies_;
};

}  // namespace rigidformer
