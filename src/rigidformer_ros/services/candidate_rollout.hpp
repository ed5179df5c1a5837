// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer_ros/inputs/frame_transformer.hpp"
#include "rigidformer_ros/services/candidate_request.hpp"

namespace rigidformer_ros {

/// The frame in which a request states its candidates: that of its scene, also where the scene is empty, or the fixed
/// frame. Throws RequestError.
rigidformer::RigidTransform T_fixed_request(const ObjectClouds& scene, const NodeParameters& parameters,
                                            const FrameTransformer& frames);

/// Reads the candidate of a PredictRollout. Throws RequestError.
rigidformer::Candidate read_candidate_of(const RolloutCandidate& message, const NodeParameters& parameters,
                                         const rigidformer::RigidTransform& T_fixed_request);

/// What a batch of one candidate came to by now, in the form of a forecast. Throws RequestError for a candidate that
/// was refused.
SceneRollout rollout_of(const BegunBatch& begun, const rigidformer::Candidate& candidate,
                        const RolloutSettings& settings);

}  // namespace rigidformer_ros
