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
using rigidformer::ParticleOutcome;
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
  const rigidformer::ObjectTrajectory& object = forecast.objects[k];
  const std::vector<rigidformer::RigidTransform>& poses = object.poses;
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
  if (settings.request.record == BatchRequest::POSES) {
    for (std::size_t i = 0; i < poses.size(); i += static_cast<std::size_t>(settings.record_every)) {
      outcome.poses.push_back(to_pose(poses[i]));
    }
    outcome.position_stddev = recorded_values(object.position_stddev_m, settings.record_every);
    outcome.rotation_stddev = recorded_values(object.rotation_stddev_rad, settings.record_every);
  } else if (!object.position_stddev_m.empty()) {
    outcome.position_stddev.push_back(static_cast<float>(object.position_stddev_m.back()));
    outcome.rotation_stddev.push_back(static_cast<float>(object.rotation_stddev_rad.back()));
  }
  return outcome;
}

// Share of the particles for which something holds; NaN without particles.
template <typename Holds>
float probability(const std::vector<ParticleOutcome>& particles, const Holds& holds) {
  if (particles.empty()) {
    return std::numeric_limits<float>::quiet_NaN();
  }
  const auto count = std::count_if(particles.begin(), particles.end(), holds);
  return static_cast<float>(count) / static_cast<float>(particles.size());
}

void fill_particles(const std::vector<ParticleOutcome>& particles, const ResultSettings& settings,
                    ObjectOutcome& outcome) {
  const double tilt_limit = settings.request.tilt_limit;
  outcome.p_settled = probability(particles, [](const ParticleOutcome& p) { return p.has_settled; });
  outcome.p_tilted = probability(particles, [&](const ParticleOutcome& p) { return p.max_tilt_rad > tilt_limit; });
  if (particles.empty()) {
    return;
  }
  for (const rigidformer::BoxRegion& region : settings.regions) {
    outcome.p_in_region.push_back(
        probability(particles, [&](const ParticleOutcome& p) { return region.contains(p.T_world_end.translation); }));
  }
  for (std::size_t i = 0; settings.request.return_particles && i < particles.size(); ++i) {
    outcome.particle_end_poses.push_back(to_pose(particles[i].T_world_end));
  }
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
      const bool has_particles = k < outcome.particles.size();
      fill_particles(has_particles ? outcome.particles[k] : std::vector<ParticleOutcome>(), settings,
                     result.objects.back());
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
