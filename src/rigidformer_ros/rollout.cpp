// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/rollout.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "rigidformer_ros/length_scale.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::Forecast;
using rigidformer::MotionMode;
using rigidformer::ObjectForecast;
using rigidformer::ObjectState;
using rigidformer::RigidTransform;
using Clock = std::chrono::steady_clock;

constexpr int kStepsPerJob = 8;

bool is_at_rest(const RigidTransform& before, const RigidTransform& after, double dt_s, const SettleCriterion& limit) {
  return (after.translation - before.translation).norm() <= limit.linear_speed_mps * dt_s &&
         rigidformer::rotation_angle(before.rotation, after.rotation) <= limit.angular_speed_rps * dt_s;
}

Forecast start_forecast(const std::vector<ObjectState>& objects) {
  Forecast forecast;
  forecast.times_s.push_back(0.0);
  for (const ObjectState& object : objects) {
    forecast.objects.push_back({object.id, ObjectForecast::Status::kOk, {object.T_world_current}});
  }
  return forecast;
}

// Keeps the last finite pose of an object whose prediction is not finite, whatever the predictor says about it.
void append_poses(ObjectForecast& whole, const ObjectForecast& part, std::size_t count) {
  for (std::size_t k = 1; k <= count; ++k) {
    const bool usable = k < part.poses.size() && rigidformer::is_valid(part.poses[k]);
    if (!usable) {
      whole.status = ObjectForecast::Status::kDiverged;
    }
    whole.poses.push_back(usable ? part.poses[k] : RigidTransform(whole.poses.back()));
  }
  if (part.status == ObjectForecast::Status::kDiverged) {
    whole.status = ObjectForecast::Status::kDiverged;
  }
}

void append(Forecast& whole, const Forecast& part, int steps, double time_step_s) {
  for (int k = 0; k < steps; ++k) {
    whole.times_s.push_back(static_cast<double>(whole.times_s.size()) * time_step_s);
  }
  for (std::size_t i = 0; i < whole.objects.size(); ++i) {
    append_poses(whole.objects[i], part.objects.at(i), static_cast<std::size_t>(steps));
  }
}

void advance(std::vector<ObjectState>& objects, const Forecast& forecast) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto& poses = forecast.objects[i].poses;
    objects[i].T_world_current = poses.back();
    objects[i].T_world_previous = poses[poses.size() - 2];
    if (forecast.objects[i].status == ObjectForecast::Status::kDiverged) {
      objects[i].mode = MotionMode::kStatic;
      objects[i].T_world_previous = poses.back();
    }
  }
}

bool all_diverged(const Forecast& forecast, const std::vector<ObjectState>& objects) {
  bool any_moving = false;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const bool diverged = forecast.objects[i].status == ObjectForecast::Status::kDiverged;
    any_moving = any_moving || diverged || objects[i].mode == MotionMode::kDynamic;
    if (objects[i].mode == MotionMode::kDynamic && !diverged) {
      return false;
    }
  }
  return any_moving;
}

std::vector<int> all_settled_steps(const Forecast& forecast, double time_step_s, const SettleCriterion& criterion) {
  std::vector<int> steps;
  for (const ObjectForecast& object : forecast.objects) {
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

int settled_step(const std::vector<RigidTransform>& poses, double time_step_s, const SettleCriterion& criterion) {
  auto step = static_cast<int>(poses.size()) - 1;
  while (step > 0 && is_at_rest(poses[step - 1], poses[step], time_step_s, criterion)) {
    --step;
  }
  const double at_rest_s = (static_cast<double>(poses.size()) - 1.0 - step) * time_step_s;
  return at_rest_s > 0.0 && at_rest_s >= criterion.duration_s ? step : -1;
}

RolloutOutcome roll_out(InferenceWorker& worker, std::vector<ObjectState> objects, const RolloutSettings& settings) {
  const Clock::time_point start = Clock::now();
  const auto elapsed_s = [start] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const double dt_s = settings.options.time_step_s;
  RolloutOutcome outcome;
  outcome.forecast = start_forecast(objects);
  outcome.settled_steps.assign(objects.size(), -1);
  while (outcome.steps_done < settings.options.num_steps && !objects.empty()) {
    if (settings.max_wall_time_s > 0.0 && elapsed_s() > settings.max_wall_time_s) {
      outcome.stop_reason = StopReason::kWallTime;
      break;
    }
    rigidformer::RolloutOptions options = settings.options;
    options.num_steps = std::min(kStepsPerJob, settings.options.num_steps - outcome.steps_done);
    const Forecast part =
        worker.predict(to_model_scale(objects, settings.length_scale), to_model_scale(options, settings.length_scale))
            .get();
    append(outcome.forecast, to_real_scale(part, settings.length_scale), options.num_steps, dt_s);
    outcome.steps_done += options.num_steps;
    advance(objects, outcome.forecast);
    outcome.settled_steps = all_settled_steps(outcome.forecast, dt_s, settings.settle);
    if (all_diverged(outcome.forecast, objects)) {
      outcome.stop_reason = StopReason::kDiverged;
      break;
    }
    if (settings.stop_when_settled && all_settled(outcome.settled_steps)) {
      outcome.stop_reason = StopReason::kSettled;
      break;
    }
  }
  outcome.forecast.compute_time_s = elapsed_s();
  return outcome;
}

}  // namespace rigidformer_ros
