// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rigidformer_ros/forecast/inference_worker.hpp"

namespace rigidformer_ros {

/// One rollout of the predictor that any number of threads want steps of. Nobody is in charge: whoever wants more steps
/// than there are asks the worker for the next few, and it goes on for as long as somebody wants more. It never has
/// more than one job with the worker, so that rollouts take turns. In real lengths and times.
class SharedRollout {
 public:
  using Clock = std::chrono::steady_clock;

  static constexpr int kStepsPerJob = 8;

  /// Jobs end at multiples of kStepsPerJob and at `ends`, of which the last is the longest. `length_scale` is real
  /// length / trained length. The worker must outlive the rollout.
  SharedRollout(InferenceWorker& worker, const std::vector<rigidformer::ObjectState>& objects,
                rigidformer::RolloutOptions options, double length_scale, std::set<int> ends, JobLane lane);

  /// Everything from the observation on to step `num_steps`, at which a job must end; empty if `limit` passed first.
  /// Diverged objects stand still from then on and keep their status. Throws if the predictor failed or the worker was
  /// stopped.
  std::optional<rigidformer::Forecast> advance_to(int num_steps, Clock::time_point limit);

  const std::vector<rigidformer::MotionMode>& modes() const { return modes_; }

 private:
  struct State;

  int next_end() const;
  std::shared_future<rigidformer::Forecast> next_job();
  void take_result();
  rigidformer::Forecast up_to(int num_steps) const;

  InferenceWorker& worker_;
  const JobLane lane_;
  const double length_scale_;
  const std::set<int> ends_;
  const std::shared_ptr<State> state_;  ///< Also held by the job, which may outlive this
  std::vector<rigidformer::MotionMode> modes_;

  std::mutex mutex_;  ///< Guards what follows
  rigidformer::Forecast forecast_;
  std::vector<int> diverged_at_;  ///< One per object: end of the job that lost it
  int steps_done_ = 0;
  std::shared_future<rigidformer::Forecast> job_;  ///< With the worker; else not valid
  std::optional<std::string> failure_;
};

}  // namespace rigidformer_ros
