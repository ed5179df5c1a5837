// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer_ros/inference_worker.hpp"
#include "rigidformer_ros/parameters.hpp"

namespace rigidformer_ros {

/// When an object counts as at rest.
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
  double length_scale = 1.0;            ///< Real length / trained length
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

/// Rolls the scene out on the worker in short jobs, so that a long request neither blocks other users of the worker nor
/// overruns its wall time by more than one job. Diverged objects stand still from then on and keep their status.
/// Throws what the predictor throws.
RolloutOutcome roll_out(InferenceWorker& worker, const std::vector<rigidformer::ObjectState>& objects,
                        const RolloutSettings& settings);

}  // namespace rigidformer_ros
