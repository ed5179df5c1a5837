// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "rigidformer/evaluation/protocol.hpp"

namespace rigidformer {

/// Prints one row per set, start, step and model with a "position m / orientation deg / position in % of the size" cell
/// per horizon, and notes below which cells were interpolated between two steps and what ends on the right face.
void print_scores(std::ostream& out, const std::vector<Score>& scores, HorizonUnit unit = HorizonUnit::kFrames);

/// Writes {"conditions": {...}, "results": [...]}. Throws std::runtime_error naming the path when it cannot be written.
void write_scores_json(const std::filesystem::path& path, const std::vector<Score>& scores,
                       const ProtocolOptions& protocol);

}  // namespace rigidformer
