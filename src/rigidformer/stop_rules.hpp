// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/candidates.hpp"

namespace rigidformer {

/// Throws std::invalid_argument for a rule that makes no sense, or names an object of which `known_ids` does not know.
void check_rules(const std::vector<StopRule>& rules, const std::vector<std::string>& known_ids);

/// The first rule that holds at the end of the last step; -1 = none does. Objects that the candidate removed do not
/// count, and a rule all of whose objects are removed never holds.
int rule_that_holds(const BatchOptions& options, const CandidateOutcome& outcome);

}  // namespace rigidformer
