// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "rigidformer/evaluation/breakdown.hpp"
#include "rigidformer/evaluation/worst_scenes.hpp"

namespace rigidformer {

/// Writes the Markdown parts of a report.
std::string conditions_text(const ProtocolOptions& options);
std::string score_table(const std::vector<Score>& scores);

/// On which face settled objects end; empty where nobody looked.
std::string settled_table(const std::vector<Score>& scores);
std::string worst_scene_line(const ScenePaths& scene);

/// "frame" or "ms".
std::string unit_name(HorizonUnit unit);

/// "frame 100" or "0.25 s".
std::string horizon_text(int horizon, HorizonUnit unit);

/// Writes an error as cells of a table, for example "0.0512 | 7.25".
std::string error_columns(const PoseError& error);

/// Writes one row per round and group, with models below each other. `group` and `counted` head their columns.
template <typename Group>
std::string partial_table(const std::string& group, const std::string& counted,
                          const std::map<RoundKey, std::map<Group, PartialScore>>& scores) {
  std::map<std::tuple<std::string, int, int, Group, std::string>, PartialScore> rows;
  for (const auto& [key, groups] : scores) {
    for (const auto& [name, score] : groups) {
      rows[{key.set, key.start, key.step, name, key.model}] = score;
    }
  }
  std::ostringstream text;
  text << "| set | start | step | " << group << " | model | " << counted
       << " | position m | orientation deg |\n|---|---|---|---|---|---|---|---|\n";
  for (const auto& [row, score] : rows) {
    std::apply([&](const auto&... columns) { ((text << "| " << columns << ' '), ...); }, row);
    text << "| " << score.count << " | " << error_columns(score.error) << " |\n";
  }
  return text.str();
}

/// Writes the rows of the table above as JSON, with the group under the name `group`.
template <typename Group>
nlohmann::json partial_json(const std::string& group, const std::map<RoundKey, std::map<Group, PartialScore>>& scores) {
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& [key, groups] : scores) {
    for (const auto& [name, score] : groups) {
      rows.push_back({{"set", key.set},
                      {"start", key.start},
                      {"step", key.step},
                      {"model", key.model},
                      {group, name},
                      {"count", score.count},
                      {"position_rmse_m", score.error.position_rmse_m},
                      {"position_rmse_sizes", score.error.position_rmse_sizes},
                      {"orientation_rmse_deg", score.error.orientation_rmse_deg}});
    }
  }
  return rows;
}

}  // namespace rigidformer
