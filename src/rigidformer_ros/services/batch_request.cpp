// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/batch_request.hpp"

#include <algorithm>
#include <cmath>

#include "rigidformer_ros/services/candidate_request.hpp"
#include "rigidformer_ros/services/request_error.hpp"

namespace rigidformer_ros {

namespace {

using Response = PredictRollout::Response;

void check_limit(const char* what, std::uint64_t value, int most, const char* parameter) {
  if (value > static_cast<std::uint64_t>(most)) {
    throw RequestError(Response::LIMIT_EXCEEDED, std::string(what) + ": " + std::to_string(value) + ", at most " +
                                                     std::to_string(most) + " are allowed (" + parameter + ")");
  }
}

void check_choice(const char* field, std::uint8_t value) {
  if (value > 1) {
    throw RequestError(Response::INVALID_REQUEST,
                       std::string(field) + ": is " + std::to_string(value) + ", must be 0 or 1");
  }
}

}  // namespace

PredictRollout::Request scene_question(const BatchRequest& request) {
  PredictRollout::Request question;
  question.num_steps = request.num_steps;
  question.time_step = request.time_step;
  question.object_ids = request.object_ids;
  question.scene = request.scene;
  question.previous_scene = request.previous_scene;
  question.control = request.control;
  question.record_every = request.record == BatchRequest::POSES ? request.record_every : 0;
  question.max_state_age = request.max_state_age;
  question.max_wall_time = request.max_wall_time;
  return question;
}

void check_limits(const BatchRequest& request, const RolloutTask& task, const NodeParameters& parameters) {
  if (request.candidates.empty()) {
    throw RequestError(Response::INVALID_REQUEST, "candidates: is empty");
  }
  check_choice("fidelity", request.fidelity);
  check_choice("record", request.record);
  const ServiceParameters& service = parameters.service;
  const std::uint64_t count = request.candidates.size();
  const auto num_steps = static_cast<std::uint64_t>(task.settings.options.num_steps);
  check_limit("candidates", count, service.max_candidates, "service/max_candidates");
  check_limit("candidates times steps", count * num_steps, service.max_candidate_steps, "service/max_candidate_steps");
  check_limit("num_particles", request.num_particles, service.max_particles, "service/max_particles");
  const std::uint64_t worlds = count * std::max<std::uint32_t>(1, request.num_particles);
  check_limit("candidates times particles times steps", worlds * num_steps, service.max_particle_steps,
              "service/max_particle_steps");
  if (!std::isfinite(request.tilt_limit) || request.tilt_limit < 0.0) {
    throw RequestError(Response::INVALID_REQUEST, "tilt_limit: is " + std::to_string(request.tilt_limit) +
                                                      " rad, must be finite and not negative");
  }
}

void check_returned_poses(const BatchRequest& request, const RolloutTask& task, std::size_t num_objects,
                          const NodeParameters& parameters) {
  const auto every = static_cast<std::uint64_t>(task.selection.record_every);
  const std::uint64_t recorded = request.record == BatchRequest::POSES
                                     ? static_cast<std::uint64_t>(task.settings.options.num_steps) / every + 1
                                     : 1;
  check_limit("poses of all candidates", request.candidates.size() * num_objects * recorded,
              parameters.service.max_returned_poses, "service/max_returned_poses");
}

ReadCandidates read_candidates(const BatchRequest& request, const NodeParameters& parameters,
                               const rigidformer::RigidTransform& T_fixed_request) {
  rigidformer::Candidate base;
  try {
    base = read_candidate(request.base, parameters, T_fixed_request);
  } catch (const std::invalid_argument& error) {
    throw RequestError(Response::INVALID_REQUEST, std::string("base: ") + error.what());
  }
  ReadCandidates read;
  try {
    read.regions = read_regions(request, T_fixed_request);
  } catch (const std::invalid_argument& error) {
    throw RequestError(Response::INVALID_REQUEST, error.what());
  }
  for (std::size_t i = 0; i < request.candidates.size(); ++i) {
    read.mistakes.emplace_back();
    try {
      read.candidates.push_back(combined(base, read_candidate(request.candidates[i], parameters, T_fixed_request)));
      read.indices.push_back(i);
    } catch (const std::invalid_argument& error) {
      read.mistakes.back() = error.what();
    }
  }
  return read;
}

rigidformer::BatchOptions read_batch_options(const BatchRequest& request, const RolloutTask& task,
                                             const NodeParameters& parameters,
                                             const std::vector<rigidformer::BoxRegion>& regions) {
  rigidformer::BatchOptions options;
  options.rollout = task.settings.options;
  options.rollout.num_particles =
      request.num_particles == 0 ? parameters.service.num_particles : static_cast<int>(request.num_particles);
  options.rollout.particle_seed = request.seed;
  options.fidelity =
      request.fidelity == BatchRequest::ENGINE ? rigidformer::Fidelity::kEngine : rigidformer::Fidelity::kModel;
  options.num_threads = parameters.service.batch_threads;
  options.settle = task.settings.settle;
  try {
    options.stop = read_stop_rules(request, regions);
  } catch (const std::invalid_argument& error) {
    throw RequestError(Response::INVALID_REQUEST, error.what());
  }
  return options;
}

}  // namespace rigidformer_ros
