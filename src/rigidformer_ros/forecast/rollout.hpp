// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer_ros/forecast/shared_rollout.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

using rigidformer::SettleCriterion;
using rigidformer::settled_step;

/// Reads the criterion from the parameters `service/settle_*`.
SettleCriterion settle_criterion(const ServiceParameters& parameters);

/// Why a rollout ended: all steps are done, all objects rest, the time is over, or all dynamic objects are lost.
enum class StopReason { kHorizon, kSettled, kWallTime, kDiverged };

/// What one user wants of a rollout.
struct RolloutSettings {
  rigidformer::RolloutOptions options;  ///< Steps, gravity and ground in real lengths and times
  double max_wall_time_s = 0.0;         ///< Time [s] from the question to the answer; 0 = no limit
  bool stop_when_settled = false;       ///< End as soon as all objects are at rest
  SettleCriterion settle;               ///< When an object is at rest
};

/// What one user got of a rollout.
struct RolloutOutcome {
  rigidformer::Forecast forecast;                 ///< Poses from the observation to the last step done
  StopReason stop_reason = StopReason::kHorizon;  ///< Why there are no more steps
  int steps_done = 0;                             ///< Number of steps in the forecast
  std::vector<int> settled_steps;                 ///< Step from which each object rests; -1 = it does not
};

/// The moment at which a rollout that was asked for at `asked` has to give up.
SharedRollout::Clock::time_point time_limit(const RolloutSettings& settings, SharedRollout::Clock::time_point asked);

/// Takes the steps that the settings ask for, unless there is a reason to stop earlier. Other users of the same rollout
/// change how long this takes, but not its result. Throws what SharedRollout throws.
RolloutOutcome roll_out(SharedRollout& rollout, const RolloutSettings& settings,
                        SharedRollout::Clock::time_point asked = SharedRollout::Clock::now());

}  // namespace rigidformer_ros
