// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer_ros/forecast/shared_rollout.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

/// When an object counts as settled; docs/conventions.md has what else is said of what moves little.
struct SettleCriterion {
  double linear_speed_mps = 0.0;
  double angular_speed_rps = 0.0;
  double duration_s = 0.0;
};

SettleCriterion settle_criterion(const ServiceParameters& parameters);

/// First step from which both speeds stay below the limits up to the end, for at least the stated duration; -1 = none.
int settled_step(const std::vector<rigidformer::RigidTransform>& poses, double time_step_s,
                 const SettleCriterion& criterion);

enum class StopReason { kHorizon, kSettled, kWallTime, kDiverged };

struct RolloutSettings {
  rigidformer::RolloutOptions options;  ///< In real lengths and times
  double max_wall_time_s = 0.0;         ///< 0 = no limit
  bool stop_when_settled = false;
  SettleCriterion settle;
};

struct RolloutOutcome {
  rigidformer::Forecast forecast;
  StopReason stop_reason = StopReason::kHorizon;
  int steps_done = 0;
  std::vector<int> settled_steps;  ///< One per object; -1 = none
};

/// When a rollout that was asked for at `asked` has to give up.
SharedRollout::Clock::time_point time_limit(const RolloutSettings& settings, SharedRollout::Clock::time_point asked);

/// Takes the steps that the settings ask for, unless there is a reason to stop earlier. Whether others take steps of
/// the same rollout changes nothing but the time. Throws what SharedRollout throws.
RolloutOutcome roll_out(SharedRollout& rollout, const RolloutSettings& settings,
                        SharedRollout::Clock::time_point asked = SharedRollout::Clock::now());

}  // namespace rigidformer_ros
