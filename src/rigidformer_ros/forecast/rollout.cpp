// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/rollout.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace rigidformer_ros {

namespace {

using rigidformer::Forecast;
using rigidformer::MotionMode;
using rigidformer::ObjectTrajectory;
using Clock = SharedRollout::Clock;

bool all_diverged(const Forecast& forecast, const std::vector<MotionMode>& modes) {
  bool any_moves = false;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] != MotionMode::kDynamic) {
      continue;
    }
    any_moves = true;
    if (forecast.objects[i].status != ObjectTrajectory::Status::kDiverged) {
      return false;
    }
  }
  return any_moves;
}

std::vector<int> all_settled_steps(const Forecast& forecast, double time_step_s, const SettleCriterion& criterion) {
  std::vector<int> steps;
  for (const ObjectTrajectory& object : forecast.objects) {
    steps.push_back(settled_step(object.poses, time_step_s, criterion));
  }
  return steps;
}

bool all_settled(const std::vector<int>& steps) {
  return !steps.empty() && std::all_of(steps.begin(), steps.end(), [](int step) { return step >= 0; });
}

}  // namespace

SettleCriterion settle_criterion(const ServiceParameters& parameters) {
  return {parameters.settle_linear_speed, parameters.settle_angular_speed, parameters.settle_duration};
}

Clock::time_point time_limit(const RolloutSettings& settings, Clock::time_point asked) {
  // [s], about 32 years, stands for "no limit": the clock counts nanoseconds in 64 bits, which hold 292 years.
  constexpr double kLongest_s = 1e9;
  const std::chrono::duration<double> allowed(
      settings.max_wall_time_s > 0.0 ? std::min(settings.max_wall_time_s, kLongest_s) : kLongest_s);
  return asked + std::chrono::duration_cast<Clock::duration>(allowed);
}

RolloutOutcome roll_out(SharedRollout& rollout, const RolloutSettings& settings, Clock::time_point asked) {
  const Clock::time_point start = Clock::now();
  const Clock::time_point limit = time_limit(settings, asked);
  RolloutOutcome outcome;
  outcome.forecast = *rollout.advance_to(0, limit);
  outcome.settled_steps.assign(rollout.modes().size(), -1);
  while (outcome.steps_done < settings.options.num_steps && !rollout.modes().empty()) {
    const int num_steps = std::min(outcome.steps_done + SharedRollout::kStepsPerJob, settings.options.num_steps);
    std::optional<Forecast> forecast = rollout.advance_to(num_steps, limit);
    if (!forecast) {
      outcome.stop_reason = StopReason::kWallTime;
      break;
    }
    outcome.forecast = std::move(*forecast);
    outcome.steps_done = num_steps;
    outcome.settled_steps = all_settled_steps(outcome.forecast, settings.options.time_step_s, settings.settle);
    if (all_diverged(outcome.forecast, rollout.modes())) {
      outcome.stop_reason = StopReason::kDiverged;
      break;
    }
    if (settings.stop_when_settled && all_settled(outcome.settled_steps)) {
      outcome.stop_reason = StopReason::kSettled;
      break;
    }
  }
  outcome.forecast.compute_time_s = std::chrono::duration<double>(Clock::now() - start).count();
  return outcome;
}

}  // namespace rigidformer_ros
