// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/batch_run.hpp"

#include <stdexcept>
#include <utility>

#include "rigidformer/length_scale.hpp"

namespace rigidformer_ros {

// What a job needs on the thread of the predictor, in the lengths and times that the model was trained on.
struct BatchRun::State {
  std::vector<rigidformer::ObjectState> objects;
  std::vector<rigidformer::Candidate> candidates;
  rigidformer::BatchOptions options;
  std::unique_ptr<rigidformer::BatchRollout> rollout;  // The first job makes it.
};

BatchRun::BatchRun(InferenceWorker& worker, const std::vector<rigidformer::ObjectState>& objects,
                   const std::vector<rigidformer::Candidate>& candidates, const rigidformer::BatchOptions& options,
                   double length_scale)
    : worker_(worker), length_scale_(length_scale), state_(std::make_shared<State>()) {
  state_->objects = rigidformer::to_model_scale(objects, length_scale);
  state_->options = rigidformer::to_model_scale(options, length_scale);
  for (const rigidformer::Candidate& candidate : candidates) {
    state_->candidates.push_back(rigidformer::to_model_scale(candidate, length_scale));
  }
}

BatchRun::Progress BatchRun::next(State& state, rigidformer::Predictor& predictor) {
  if (!state.rollout) {
    state.rollout = predictor.start_batch(state.objects, state.candidates, state.options);
  }
  Progress progress;
  progress.is_running = state.rollout->advance(kJob_s);
  progress.outcomes = state.rollout->outcomes();
  progress.unusable = state.rollout->unusable();
  return progress;
}

void BatchRun::advance(Clock::time_point limit) {
  if (!job_.valid()) {
    job_ = worker_.run([state = state_](rigidformer::Predictor& predictor) { return next(*state, predictor); },
                       JobLane::kRequest);
  }
  if (job_.wait_until(limit) != std::future_status::ready) {
    return;
  }
  try {
    progress_ = job_.get();
  } catch (const std::future_error&) {
    throw std::runtime_error("the rollout was ended: the node shuts down");
  }
  for (rigidformer::CandidateOutcome& outcome : progress_.outcomes) {
    outcome = rigidformer::to_real_scale(std::move(outcome), length_scale_);
  }
}

}  // namespace rigidformer_ros
