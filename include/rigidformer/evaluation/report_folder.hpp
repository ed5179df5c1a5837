// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigidformer/evaluation/breakdown.hpp"
#include "rigidformer/evaluation/protocol.hpp"
#include "rigidformer/evaluation/worst_scenes.hpp"

namespace rigidformer {

/// Collects results and writes them as a folder that a person can look at: report.md with tables and pictures,
/// scores.json, breakdown.json, error_*.svg with errors over time and worst_*.svg with the paths of the worst scenes.
/// Without gnuplot there are no pictures, and report.md says so.
class ReportFolder {
 public:
  /// Makes the folder. `first_model` is the one whose worst scenes are shown. Throws std::runtime_error when the folder
  /// cannot be made.
  ReportFolder(const std::filesystem::path& folder, const std::string& first_model, const ProtocolOptions& options);

  void add(const SceneResult& result);

  /// Throws std::runtime_error naming the file that cannot be written.
  void write(const std::vector<Score>& scores) const;

 private:
  std::filesystem::path folder_;
  std::string first_model_;
  ProtocolOptions options_;
  Breakdown breakdown_;
  WorstScenes worst_;
};

}  // namespace rigidformer
