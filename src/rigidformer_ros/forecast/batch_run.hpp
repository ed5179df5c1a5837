// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <vector>

#include "rigidformer/candidates.hpp"
#include "rigidformer_ros/forecast/inference_worker.hpp"

namespace rigidformer_ros {

/// Candidates of one scene on the thread of the predictor, a short job at a time, so that the forecast and other
/// rollouts get their turn in between. All lengths and times are real ones. One thread uses it.
class BatchRun {
 public:
  using Clock = std::chrono::steady_clock;

  /// [s] A job's length: about that of a job of a SharedRollout with a few objects. Chosen by eye.
  static constexpr double kJob_s = 0.05;

  /// `length_scale` is a real length divided by the length that the model sees. The worker must outlive the batch.
  BatchRun(InferenceWorker& worker, const std::vector<rigidformer::ObjectState>& objects,
           const std::vector<rigidformer::Candidate>& candidates, const rigidformer::BatchOptions& options,
           double length_scale);

  /// Waits until more steps are done, but not beyond `limit`. Throws what the predictor throws.
  void advance(Clock::time_point limit);

  /// Whether candidates are still in progress.
  bool is_running() const { return progress_.is_running; }

  /// Where the candidates were after the last job; empty before the first one.
  const std::vector<rigidformer::CandidateOutcome>& outcomes() const { return progress_.outcomes; }

  /// Objects of the scene that the predictor left out.
  const std::vector<rigidformer::ObjectTrajectory>& unusable() const { return progress_.unusable; }

 private:
  struct State;
  struct Progress {
    bool is_running = true;
    std::vector<rigidformer::CandidateOutcome> outcomes;
    std::vector<rigidformer::ObjectTrajectory> unusable;
  };

  static Progress next(State& state, rigidformer::Predictor& predictor);

  InferenceWorker& worker_;
  double length_scale_;
  std::shared_ptr<State> state_;  ///< The job holds it too, because the job may outlive this object
  std::future<Progress> job_;     ///< The job that the worker has; not valid when it has none
  Progress progress_;
};

}  // namespace rigidformer_ros
