// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fixture_shapes.hpp"
#include "motion_path.hpp"
#include "random_draws.hpp"

namespace rigidformer {

/// Scales of a scene that drivers act in.
struct DriverScale {
  double unit_m = 1.0;      ///< The length that objects of about 1 m have
  double duration_s = 2.0;  ///< Of the recording

  /// Speeds scale with the square root of lengths, as those of what falls.
  double unit_mps() const { return std::sqrt(unit_m); }
  /// What takes 1 s where objects are about 1 m large, but no more than a third of the recording.
  double unit_s() const { return std::min(std::sqrt(unit_m), duration_s / 3.0); }
};

/// Bodies that move together: a pusher, a palm, the two fingers of a gripper.
struct Driver {
  std::vector<Block> blocks;
  std::vector<MotionPath> paths;  ///< Of every block, from the beginning of the recording on
  bool grips = false;
};

/// How far [m] a block moves from a pose in world along a unit direction until it touches something, but no farther
/// than `most_m`; empty = nowhere, or it overlaps something already.
using Reach = std::function<std::optional<double>(const Block& block, const RigidTransform& T_world_block,
                                                  const Eigen::Vector3d& direction, double most_m)>;

/// An object at rest that a driver goes for.
struct DriverTarget {
  Eigen::AlignedBox3d bounds_world;  ///< Its lower side lies on what carries it
  Reach reach;
};

/// A box or a peg that comes level, pushes and stops or goes back, again and again; empty where it finds no way.
std::optional<Driver> draw_pusher(const DriverScale& scale, const DriverTarget& target, Random& random);

/// Two fingers that close on the object, lift, carry and release it; empty where they cannot reach it.
std::optional<Driver> draw_gripper(const DriverScale& scale, const DriverTarget& target, Random& random);

/// A level slab above `foot_world` that lifts, carries and tilts what lies on it.
Driver draw_palm(const DriverScale& scale, const Eigen::Vector3d& foot_world, Random& random);

}  // namespace rigidformer
