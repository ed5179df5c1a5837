// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "drivers.hpp"
#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {

/// The bodies of a scene that is being drawn, at its beginning: tells what overlaps, and lets objects come to rest.
class FixtureRoom {
 public:
  FixtureRoom(const std::vector<Shape>& shapes, const BulletSettings& settings, double unit_m)
      : shapes_(shapes), world_(settings), obstacles_(settings), unit_m_(unit_m) {}

  void add_static(const Block& block, const RigidTransform& T_world_block);

  /// Whether a driver keeps above the floor and clear of fixtures and of other drivers during the recording.
  bool has_way(const Driver& driver, double duration_s);

  /// Adds a driver where it begins. False, and nothing added, where it overlaps something there.
  bool add_driver(const Driver& driver);

  /// Lets an object fall on what is below `foot_world`, from just above it. Returns its pose at rest, or nothing and
  /// leaves it away where it does not come to rest near there.
  std::optional<RigidTransform> seat(const RecordedObject& object, const Eigen::Vector3d& foot_world, Random& random);

  /// Adds an object where it touches nothing; false, and nothing added, elsewhere.
  bool add_free(const RecordedObject& object, const RigidTransform& T_world_object);

  Reach reach();

  /// The box around an object at a pose.
  Eigen::AlignedBox3d bounds(const RecordedObject& object, const RigidTransform& T_world_object) const;

 private:
  int add_given(BulletWorld& world, const Block& block, const RigidTransform& T_world_block) const;
  bool comes_to_rest(int body, const Eigen::Vector3d& foot_world);

  const std::vector<Shape>& shapes_;
  BulletWorld world_;      ///< All bodies
  BulletWorld obstacles_;  ///< Fixtures and drivers
  std::vector<MotionPath> driver_paths_;
  std::vector<int> driver_bodies_;  ///< Of `obstacles_`
  double unit_m_;
};

}  // namespace rigidformer
