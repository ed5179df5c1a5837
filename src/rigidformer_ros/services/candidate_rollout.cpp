// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/candidate_rollout.hpp"

#include <rigidformer_ros/PredictRollout.h>

#include <stdexcept>

#include "rigidformer_ros/services/request_error.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::CandidateOutcome;
using Codes = PredictRollout::Response;

StopReason to_stop_reason(CandidateOutcome::Stop stop) {
  switch (stop) {
    case CandidateOutcome::Stop::kRunning:
      return StopReason::kWallTime;
    case CandidateOutcome::Stop::kRule:
      return StopReason::kSettled;
    case CandidateOutcome::Stop::kDiverged:
      return StopReason::kDiverged;
    default:
      return StopReason::kHorizon;
  }
}

void check(const CandidateOutcome& outcome) {
  switch (outcome.error) {
    case CandidateOutcome::Error::kNone:
      return;
    case CandidateOutcome::Error::kUnknownObject:
      throw RequestError(Codes::UNKNOWN_OBJECT, "candidate: " + outcome.message);
    case CandidateOutcome::Error::kInvalid:
      throw RequestError(Codes::INVALID_REQUEST, "candidate: " + outcome.message);
    default:
      throw std::runtime_error(outcome.message);
  }
}

// A candidate that has not taken a step yet.
rigidformer::Forecast observation(const ObservedScene& scene) {
  rigidformer::Forecast forecast;
  forecast.times_s.push_back(0.0);
  for (const ObservedObject& object : scene.objects) {
    forecast.objects.push_back(
        {object.state.id, rigidformer::ObjectTrajectory::Status::kOk, {object.state.T_world_current}});
  }
  return forecast;
}

}  // namespace

rigidformer::RigidTransform T_fixed_request(const ObjectClouds& scene, const NodeParameters& parameters,
                                            const FrameTransformer& frames) {
  if (scene.header.frame_id.empty() || scene.header.frame_id == parameters.fixed_frame) {
    return {};
  }
  try {
    return frames.T_fixed_from(scene.header.frame_id, scene.header.stamp);
  } catch (const TransformError& error) {
    throw RequestError(Codes::FRAME_TRANSFORM_FAILURE, std::string("scene.header.frame_id: ") + error.what());
  }
}

rigidformer::Candidate read_candidate_of(const RolloutCandidate& message, const NodeParameters& parameters,
                                         const rigidformer::RigidTransform& T_fixed_request) {
  try {
    return read_candidate(message, parameters, T_fixed_request);
  } catch (const std::invalid_argument& error) {
    throw RequestError(Codes::INVALID_REQUEST, std::string("candidate.") + error.what());
  }
}

SceneRollout rollout_of(const BegunBatch& begun, const rigidformer::Candidate& candidate,
                        const RolloutSettings& settings) {
  CandidateOutcome outcome;
  if (!begun.run.outcomes().empty()) {
    outcome = begun.run.outcomes().front();
  }
  check(outcome);
  SceneRollout rollout;
  rollout.scene = scene_of_candidate(begun.scene, candidate, begun.run.unusable());
  rollout.model = begun.model;
  rollout.outcome.forecast = outcome.forecast.times_s.empty() ? observation(rollout.scene) : outcome.forecast;
  rollout.outcome.stop_reason = to_stop_reason(outcome.stop);
  rollout.outcome.steps_done = static_cast<int>(rollout.outcome.forecast.times_s.size()) - 1;
  for (const rigidformer::ObjectTrajectory& object : rollout.outcome.forecast.objects) {
    rollout.outcome.settled_steps.push_back(settled_step(object.poses, begun.scene.time_step_s, settings.settle));
  }
  return rollout;
}

}  // namespace rigidformer_ros
