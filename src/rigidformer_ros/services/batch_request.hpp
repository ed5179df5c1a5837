// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/BatchRequest.h>
#include <rigidformer_ros/BatchResult.h>
#include <rigidformer_ros/PredictRollout.h>

#include <optional>
#include <string>
#include <vector>

#include "rigidformer/candidates.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"
#include "rigidformer_ros/services/rollout_request.hpp"

namespace rigidformer_ros {

/// What a BatchRequest has in common with a PredictRollout: which scene, how many steps, which objects, how long.
PredictRollout::Request scene_question(const BatchRequest& request);

/// Candidates and regions as they were read, and what is wrong with those that could not be.
struct ReadCandidates {
  std::vector<rigidformer::Candidate> candidates;    ///< The good ones, with the changes of `base`
  std::vector<std::size_t> indices;                  ///< Where in the request each of them stands
  std::vector<std::optional<std::string>> mistakes;  ///< One per candidate of the request
  std::vector<rigidformer::BoxRegion> regions;       ///< In the fixed frame
};

/// Checks the limits of a request; throws RequestError.
void check_limits(const BatchRequest& request, const RolloutTask& task, const NodeParameters& parameters);

void check_returned_poses(const BatchRequest& request, const RolloutTask& task, std::size_t num_objects,
                          const NodeParameters& parameters);

/// Reads all candidates and regions. A mistake in `base` or a region is one of the request: throws RequestError.
ReadCandidates read_candidates(const BatchRequest& request, const NodeParameters& parameters,
                               const rigidformer::RigidTransform& T_fixed_request);

/// What holds for all candidates; throws RequestError.
rigidformer::BatchOptions read_batch_options(const BatchRequest& request, const RolloutTask& task,
                                             const NodeParameters& parameters,
                                             const std::vector<rigidformer::BoxRegion>& regions);

}  // namespace rigidformer_ros
