// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/BatchRequest.h>
#include <rigidformer_ros/CandidateResult.h>

#include <string>
#include <vector>

#include "rigidformer/candidates.hpp"
#include "rigidformer_ros/forecast/scene_forecaster.hpp"

namespace rigidformer_ros {

/// What is the same for all results of a request.
struct ResultSettings {
  const BegunBatch& begun;
  const BatchRequest& request;
  int record_every = 1;
  rigidformer::SettleCriterion settle;
  std::vector<rigidformer::BoxRegion> regions;  ///< In the fixed frame
};

/// The result of a candidate; one that is still running ended for the reason `unfinished` (a stop reason and an error
/// code of PredictRollout).
struct Unfinished {
  std::uint8_t stop_reason = 0;
  std::int32_t error_code = 0;
  std::string message;
};
CandidateResult to_result(const rigidformer::CandidateOutcome& outcome, const rigidformer::Candidate& candidate,
                          const ResultSettings& settings, const Unfinished& unfinished);

/// The result of a candidate that could not be read.
CandidateResult refused_result(const std::string& name, const std::string& mistake);

}  // namespace rigidformer_ros
