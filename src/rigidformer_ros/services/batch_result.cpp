// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/batch_result.hpp"

#include <rigidformer_ros/PredictRollout.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "rigidformer_ros/messages/conversions.hpp"
#include "rigidformer_ros/services/candidate_request.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::Candidate;
using rigidformer::CandidateOutcome;
using Codes = PredictRollout::Response;

std::int32_t code_of(CandidateOutcome::Error error) {
  switch (error) {
    case CandidateOutcome::Error::kNone:
      return Codes::SUCCESS;
    case CandidateOutcome::Error::kUnknownObject:
      return Codes::UNKNOWN_OBJECT;
    case CandidateOutcome::Error::kInvalid:
      return Codes::INVALID_REQUEST;
    default:
      return Codes::INTERNAL;
  }
}

ObjectOutcome to_outcome(const SceneRollout& rollout, std::size_t k, const ResultSettings& settings) {
  const rigidformer::Forecast& forecast = rollout.outcome.forecast;
  const std::vector<rigidformer::RigidTransform>& poses = forecast.objects[k].poses;
  const rigidformer::ObjectState& state = rollout.scene.objects[k].state;
  const double dt_s = rollout.scene.time_step_s;
  ObjectOutcome outcome;
  outcome.id = forecast.objects[k].id;
  outcome.status = status_of(rollout, k);
  outcome.end_pose = to_pose(poses.back());
  outcome.end_twist = poses.size() < 2 ? twist_between(state.T_world_previous, state.T_world_current, dt_s)
                                       : twist_between(poses[poses.size() - 2], poses.back(), dt_s);
  outcome.first_contact_step = rigidformer::first_contact_step(forecast, static_cast<int>(k));
  outcome.settled_step = rigidformer::settled_step(poses, dt_s, settings.settle);
  outcome.max_tilt = rigidformer::max_tilt(poses);
  outcome.path_length = rigidformer::path_length(poses);
  outcome.p_settled = outcome.p_tilted = std::numeric_limits<float>::quiet_NaN();
  if (settings.request.record == BatchRequest::POSES) {
    for (std::size_t i = 0; i < poses.size(); i += static_cast<std::size_t>(settings.record_every)) {
      outcome.poses.push_back(to_pose(poses[i]));
    }
  }
  return outcome;
}

// Objects of the scene that were asked for, and those that only tracks know.
ForecastSelection selection_for(const Candidate& candidate, const BatchRequest& request) {
  ForecastSelection selection{request.object_ids, 1};
  if (!selection.object_ids.empty()) {
    for (const rigidformer::GivenTrack& track : candidate.tracks) {
      if (track.points_reference.rows() > 0) {
        selection.object_ids.push_back(track.id);
      }
    }
  }
  return selection;
}

void fill_objects(CandidateResult& result, const CandidateOutcome& outcome, const Candidate& candidate,
                  const ResultSettings& settings) {
  SceneRollout rollout;
  rollout.scene = scene_of_candidate(settings.begun.scene, candidate, settings.begun.run.unusable());
  rollout.outcome.forecast = outcome.forecast;
  rollout.model = settings.begun.model;
  const ForecastSelection selection = selection_for(candidate, settings.request);
  for (std::size_t k = 0; k < outcome.forecast.objects.size(); ++k) {
    const std::string& id = outcome.forecast.objects[k].id;
    if (selection.object_ids.empty() || std::count(selection.object_ids.begin(), selection.object_ids.end(), id) > 0) {
      result.objects.push_back(to_outcome(rollout, k, settings));
    }
  }
  result.contacts = contact_events(outcome.forecast, selection);
}

void fill_end(CandidateResult& result, const CandidateOutcome& outcome, const Unfinished& unfinished) {
  result.error_code = code_of(outcome.error);
  result.message = outcome.message;
  switch (outcome.stop) {
    case CandidateOutcome::Stop::kRunning:
      result.stop_reason = unfinished.stop_reason;
      result.error_code = unfinished.error_code;
      result.message = unfinished.message;
      break;
    case CandidateOutcome::Stop::kHorizon:
      result.stop_reason = CandidateResult::STOP_HORIZON;
      break;
    case CandidateOutcome::Stop::kRule:
      result.stop_reason = CandidateResult::STOP_CONDITION;
      break;
    case CandidateOutcome::Stop::kDiverged:
      result.stop_reason = CandidateResult::STOP_DIVERGED;
      break;
    case CandidateOutcome::Stop::kRefused:
      result.stop_reason = CandidateResult::STOP_ERROR;
      break;
  }
  for (const rigidformer::ObjectTrajectory& object : outcome.forecast.objects) {
    if (object.status == rigidformer::ObjectTrajectory::Status::kDiverged && result.error_code == Codes::SUCCESS) {
      result.error_code = Codes::DIVERGED;
      result.message = "object '" + object.id + "': its prediction stopped being finite";
    }
  }
}

}  // namespace

CandidateResult to_result(const CandidateOutcome& outcome, const Candidate& candidate, const ResultSettings& settings,
                          const Unfinished& unfinished) {
  CandidateResult result;
  result.name = outcome.name;
  result.stop_condition = outcome.rule;
  result.steps_done = static_cast<std::uint32_t>(std::max<std::size_t>(1, outcome.forecast.times_s.size()) - 1);
  fill_end(result, outcome, unfinished);
  if (outcome.stop != CandidateOutcome::Stop::kRefused && !outcome.forecast.objects.empty()) {
    fill_objects(result, outcome, candidate, settings);
  }
  return result;
}

CandidateResult refused_result(const std::string& name, const std::string& mistake) {
  CandidateResult result;
  result.name = name;
  result.error_code = Codes::INVALID_REQUEST;
  result.message = mistake;
  result.stop_reason = CandidateResult::STOP_ERROR;
  result.stop_condition = -1;
  return result;
}

}  // namespace rigidformer_ros
