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

/// One rollout of the predictor that any number of threads want steps of. No thread is in charge: whoever wants more
/// steps than there are asks the worker for the next few, and the rollout goes on for as long as somebody wants more.
/// It never has more than one job with the worker, so that rollouts take turns. All lengths and times are real ones.
class SharedRollout {
 public:
  using Clock = std::chrono::steady_clock;

  /// Steps of the predictor in one job. Jobs are short so that the forecast and other rollouts get their turn in
  /// between. The number was chosen by eye.
  static constexpr int kStepsPerJob = 8;

  /// A job ends at every multiple of kStepsPerJob and at every number in `ends`; the last of `ends` is the longest
  /// rollout that anyone wants. `length_scale` is a real length divided by the length that the model sees. The worker
  /// must outlive the rollout.
  SharedRollout(InferenceWorker& worker, const std::vector<rigidformer::ObjectState>& objects,
                rigidformer::RolloutOptions options, double length_scale, std::set<int> ends, JobLane lane);

  /// Gives all poses from the observation up to step `num_steps`, at which a job must end. The result is empty if
  /// `limit` passed first. A diverged object stands still from then on and keeps that status. Throws if the predictor
  /// failed or the worker was stopped.
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
  const std::shared_ptr<State> state_;  ///< The job holds it too, because the job may outlive this object
  std::vector<rigidformer::MotionMode> modes_;

  std::mutex mutex_;  ///< Guards all members below
  rigidformer::Forecast forecast_;
  std::vector<int> diverged_at_;  ///< For each object the last step of the job that lost it
  int steps_done_ = 0;
  std::shared_future<rigidformer::Forecast> job_;  ///< The job that the worker has; not valid when it has none
  std::optional<std::string> failure_;
};

}  // namespace rigidformer_ros
