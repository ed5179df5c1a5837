// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/rollout.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
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

// Keeps the last finite pose of an object whose prediction is not finite, whatever the predictor says about it.
Forecast with_finite_poses(Forecast forecast) {
  for (ObjectForecast& object : forecast.objects) {
    bool lost = false;
    for (std::size_t k = 1; k < object.poses.size(); ++k) {
      lost = lost || !rigidformer::is_valid(object.poses[k]);
      if (lost) {
        object.status = ObjectForecast::Status::kDiverged;
        object.poses[k] = object.poses[k - 1];
      }
    }
  }
  return forecast;
}

bool all_diverged(const Forecast& forecast, const std::vector<ObjectState>& objects) {
  bool any_moves = false;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].mode != MotionMode::kDynamic) {
      continue;
    }
    any_moves = true;
    if (forecast.objects[i].status != ObjectForecast::Status::kDiverged) {
      return false;
    }
  }
  return any_moves;
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

Forecast start_forecast(const std::vector<ObjectState>& objects) {
  Forecast forecast;
  forecast.times_s.push_back(0.0);
  for (const ObjectState& object : objects) {
    forecast.objects.push_back({object.id, ObjectForecast::Status::kOk, {object.T_world_current}});
  }
  return forecast;
}

// A rollout that lets others have the worker between its jobs. In real lengths and times.
class PiecewiseRollout {
 public:
  PiecewiseRollout(InferenceWorker& worker, const std::vector<ObjectState>& objects, const RolloutSettings& settings)
      : worker_(worker),
        length_scale_(settings.length_scale),
        state_(std::make_shared<State>(
            State{to_model_scale(objects, length_scale_), to_model_scale(settings.options, length_scale_), nullptr})) {}

  // From the observation to `num_steps` more steps than before.
  Forecast advance(int num_steps) {
    const auto job = [state = state_, num_steps](rigidformer::Predictor& predictor) {
      if (!state->rollout) {
        state->rollout = predictor.start(state->objects, state->options);
      }
      return state->rollout->advance(num_steps);
    };
    return with_finite_poses(to_real_scale(worker_.run(job).get(), length_scale_));
  }

 private:
  struct State {
    std::vector<ObjectState> objects;
    rigidformer::RolloutOptions options;
    std::unique_ptr<rigidformer::Rollout> rollout;  // made on the thread of the predictor
  };

  InferenceWorker& worker_;
  double length_scale_;
  std::shared_ptr<State> state_;
};

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

RolloutOutcome roll_out(InferenceWorker& worker, const std::vector<ObjectState>& objects,
                        const RolloutSettings& settings) {
  const Clock::time_point start = Clock::now();
  const auto elapsed_s = [start] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  PiecewiseRollout rollout(worker, objects, settings);
  RolloutOutcome outcome;
  outcome.forecast = start_forecast(objects);
  outcome.settled_steps.assign(objects.size(), -1);
  while (outcome.steps_done < settings.options.num_steps && !objects.empty()) {
    if (settings.max_wall_time_s > 0.0 && elapsed_s() > settings.max_wall_time_s) {
      outcome.stop_reason = StopReason::kWallTime;
      break;
    }
    const int num_steps = std::min(kStepsPerJob, settings.options.num_steps - outcome.steps_done);
    outcome.forecast = rollout.advance(num_steps);
    outcome.steps_done += num_steps;
    outcome.settled_steps = all_settled_steps(outcome.forecast, settings.options.time_step_s, settings.settle);
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
