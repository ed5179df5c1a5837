// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/model_forecaster.hpp"

#include <stdexcept>
#include <utility>

namespace rigidformer {
namespace {

/// No score for what was not predicted.
void refuse_unusable(const ObjectTrajectory& object) {
  if (object.status != ObjectTrajectory::Status::kUnusable) return;
  throw std::invalid_argument("object '" + object.id + "': " + object.reason);
}

/// The forecast of a scene in which some objects follow tracks.
std::vector<ObjectTrajectory> predict_among(Predictor& predictor, const std::vector<ObjectState>& objects,
                                            const RolloutOptions& rollout, const std::vector<GivenTrack>& tracks) {
  Candidate candidate;
  candidate.tracks = tracks;
  BatchOptions options;
  options.rollout = rollout;
  const auto batch = predictor.start_batch(objects, {candidate}, options);
  for (const ObjectTrajectory& object : batch->unusable()) refuse_unusable(object);
  while (batch->advance()) continue;
  const CandidateOutcome& outcome = batch->outcomes().front();
  if (outcome.error != CandidateOutcome::Error::kNone) throw std::invalid_argument(outcome.message);
  return outcome.forecast.objects;
}

}  // namespace

std::vector<std::vector<RigidTransform>> ModelForecaster::forecast(const std::vector<ObjectState>& objects,
                                                                   const RolloutOptions& rollout,
                                                                   const std::vector<GivenTrack>& tracks) {
  std::vector<std::vector<RigidTransform>> poses;
  for (ObjectTrajectory& object : tracks.empty() ? predictor_.predict(objects, rollout).objects
                                                 : predict_among(predictor_, objects, rollout, tracks)) {
    refuse_unusable(object);
    object.poses.resize(rollout.num_steps + 1, object.poses.back());
    poses.push_back(std::move(object.poses));
  }
  return poses;
}

}  // namespace rigidformer
