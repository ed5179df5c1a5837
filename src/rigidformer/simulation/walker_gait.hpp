// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "walker_design.hpp"

namespace rigidformer {

/// What a walker is told (App. I.1).
struct WalkerCommand {
  double speed_mps = 0.0;
  double direction_rad = 0.0;        ///< Where to walk, from the world's x axis about z
  std::optional<double> facing_rad;  ///< Where the head looks; empty without a head

  /// (speed, direction x, y) and, with a head, (facing x, y).
  std::vector<double> numbers() const;
};

/// Turns commands into angles of the joints: the torso turns to where it is to walk, legs on the ground go back as the
/// torso goes forward, the others swing ahead in an arc. One half of the legs stands while the other swings.
class WalkerGait {
 public:
  /// `phase` in cycles, where the gait begins.
  WalkerGait(const WalkerDesign& design, double phase) : design_(design), phase_(phase) {}

  /// Angles of all hinges [rad] `time_step_s` later, for a torso that is turned by `yaw_rad` about the vertical.
  std::vector<double> advance(const WalkerCommand& command, double yaw_rad, double time_step_s);

 private:
  void place_leg(const WalkerLeg& leg, std::vector<double>& angles) const;

  const WalkerDesign& design_;
  double phase_;
  double forward_mps_ = 0.0, turn_radps_ = 0.0;  ///< What the legs are to give the torso
  double look_rad_ = 0.0;                        ///< Angle of the neck
};

}  // namespace rigidformer
