// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "walker_design.hpp"

namespace rigidformer {

/// A walker on the floor z = 0 in Bullet: rigid bodies on hinges with position motors. Parts meet the floor, but not
/// each other.
class WalkerWorld {
 public:
  WalkerWorld(const WalkerDesign& design, double yaw_rad);
  ~WalkerWorld();

  /// Steps by `time_step_s` while the motors pull the hinges to `angles` [rad].
  void step(const std::vector<double>& angles, double time_step_s);

  RigidTransform T_world_part(std::size_t part) const;
  double yaw_rad() const;  ///< Of the torso

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Friction of parts, and of the floor with them, and restitution of both.
constexpr double kWalkerFriction = 0.9, kWalkerRestitution = 0.0;

}  // namespace rigidformer
