// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/BatchRequest.h>
#include <rigidformer_ros/RolloutCandidate.h>

#include <string>
#include <vector>

#include "rigidformer/candidates.hpp"
#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

/// Whether a candidate changes nothing.
bool is_empty(const RolloutCandidate& candidate);

/// Reads a candidate and brings it into the fixed frame. Throws std::invalid_argument naming the field at fault.
rigidformer::Candidate read_candidate(const RolloutCandidate& message, const NodeParameters& parameters,
                                      const rigidformer::RigidTransform& T_fixed_request);

/// The changes of `base` and then those of `own`, under the name of `own`.
rigidformer::Candidate combined(const rigidformer::Candidate& base, rigidformer::Candidate own);

/// Reads the boxes of a request, in the fixed frame. Throws std::invalid_argument naming the field.
std::vector<rigidformer::BoxRegion> read_regions(const BatchRequest& request,
                                                 const rigidformer::RigidTransform& T_fixed_request);

/// Reads the conditions that end candidates. Throws std::invalid_argument naming the field.
std::vector<rigidformer::StopRule> read_stop_rules(const BatchRequest& request,
                                                   const std::vector<rigidformer::BoxRegion>& regions);

/// The scene as a candidate makes it, its objects in the order of the candidate's outcome. `unusable` are those that
/// the predictor left out. The candidate must be one that was not refused.
ObservedScene scene_of_candidate(const ObservedScene& scene, const rigidformer::Candidate& candidate,
                                 const std::vector<rigidformer::ObjectTrajectory>& unusable);

}  // namespace rigidformer_ros
