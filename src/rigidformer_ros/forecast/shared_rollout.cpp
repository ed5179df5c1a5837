// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/shared_rollout.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rigidformer/length_scale.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::Forecast;
using rigidformer::ObjectState;
using rigidformer::ObjectTrajectory;

// Step number of an object that was never lost: it lies beyond every step that a rollout can have.
constexpr int kNever = std::numeric_limits<int>::max();

// Keeps the last finite pose of an object whose prediction is not finite, whatever the predictor says about it.
Forecast with_finite_poses(Forecast forecast) {
  for (ObjectTrajectory& object : forecast.objects) {
    bool lost = false;
    for (std::size_t k = 1; k < object.poses.size(); ++k) {
      lost = lost || !rigidformer::is_valid(object.poses[k]);
      if (lost) {
        object.status = ObjectTrajectory::Status::kDiverged;
        object.poses[k] = object.poses[k - 1];
      }
    }
  }
  return forecast;
}

Forecast observation(const std::vector<ObjectState>& objects) {
  Forecast forecast;
  forecast.times_s.push_back(0.0);
  for (const ObjectState& object : objects) {
    forecast.objects.push_back({object.id, ObjectTrajectory::Status::kOk, {object.T_world_current}});
  }
  return forecast;
}

bool is_over(const std::shared_future<Forecast>& job) {
  return job.valid() && job.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

// What a job needs on the thread of the predictor, in the lengths and times that the model was trained on.
struct SharedRollout::State {
  std::vector<ObjectState> objects;
  rigidformer::RolloutOptions options;
  std::unique_ptr<rigidformer::Rollout> rollout;  // The first job makes it: only its thread may call the predictor.
};

SharedRollout::SharedRollout(InferenceWorker& worker, const std::vector<ObjectState>& objects,
                             rigidformer::RolloutOptions options, double length_scale, std::set<int> ends, JobLane lane)
    : worker_(worker),
      lane_(lane),
      length_scale_(length_scale),
      ends_(std::move(ends)),
      state_(std::make_shared<State>()),
      forecast_(observation(objects)),
      diverged_at_(objects.size(), kNever) {
  options.num_steps = *ends_.rbegin();
  state_->objects = to_model_scale(objects, length_scale);
  state_->options = to_model_scale(options, length_scale);
  for (const ObjectState& object : objects) {
    modes_.push_back(object.mode);
  }
}

std::optional<Forecast> SharedRollout::advance_to(int num_steps, Clock::time_point limit) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (steps_done_ < num_steps) {
    if (is_over(job_)) {
      take_result();
      continue;
    }
    if (failure_) {
      throw std::runtime_error(*failure_);
    }
    if (Clock::now() >= limit) {
      return std::nullopt;
    }
    if (!job_.valid()) {
      job_ = next_job();
    }
    const std::shared_future<Forecast> job = job_;
    lock.unlock();
    job.wait_until(limit);
    lock.lock();
  }
  return up_to(num_steps);
}

int SharedRollout::next_end() const {
  const int full_job = (steps_done_ / kStepsPerJob + 1) * kStepsPerJob;
  const auto end = ends_.upper_bound(steps_done_);
  return end == ends_.end() ? full_job : std::min(full_job, *end);
}

std::shared_future<Forecast> SharedRollout::next_job() {
  const auto job = [state = state_, num_steps = next_end() - steps_done_](rigidformer::Predictor& predictor) {
    if (!state->rollout) {
      state->rollout = predictor.start(state->objects, state->options);
    }
    return state->rollout->advance(num_steps);
  };
  return worker_.run(job, lane_).share();
}

void SharedRollout::take_result() {
  try {
    forecast_ = with_finite_poses(to_real_scale(job_.get(), length_scale_));
    steps_done_ = next_end();
    for (std::size_t i = 0; i < diverged_at_.size(); ++i) {
      if (forecast_.objects[i].status == ObjectTrajectory::Status::kDiverged) {
        diverged_at_[i] = std::min(diverged_at_[i], steps_done_);
      }
    }
  } catch (const std::future_error&) {
    failure_ = "the rollout was ended: the node shuts down";
  } catch (const std::exception& error) {
    failure_ = error.what();
  }
  job_ = {};
}

Forecast SharedRollout::up_to(int num_steps) const {
  const auto first_of = [count = static_cast<std::size_t>(num_steps) + 1](const auto& all) {
    using List = std::decay_t<decltype(all)>;
    return List(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(count, all.size())));
  };
  Forecast forecast;
  forecast.times_s = first_of(forecast_.times_s);
  for (const rigidformer::StepContact& contact : forecast_.contacts) {
    if (contact.step <= num_steps) {
      forecast.contacts.push_back(contact);
    }
  }
  for (std::size_t i = 0; i < forecast_.objects.size(); ++i) {
    const ObjectTrajectory& object = forecast_.objects[i];
    const bool diverges_later = object.status == ObjectTrajectory::Status::kDiverged && diverged_at_[i] > num_steps;
    forecast.objects.push_back({object.id, diverges_later ? ObjectTrajectory::Status::kOk : object.status,
                                first_of(object.poses), object.reason, first_of(object.position_stddev_m),
                                first_of(object.rotation_stddev_rad)});
  }
  return forecast;
}

}  // namespace rigidformer_ros
