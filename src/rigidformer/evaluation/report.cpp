// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/report.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

constexpr int kCellWidth = 24;

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[128];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

bool same_row(const Score& a, const Score& b) {
  return a.set == b.set && a.start == b.start && a.step == b.step && a.model == b.model;
}

std::string cell(const Score& score) {
  return format("%8.4f /%6.2f /%5.1f %%", score.error.position_rmse_m, score.error.orientation_rmse_deg,
                100.0 * score.error.position_rmse_sizes);
}

std::string padded(const std::string& text) { return format("%*s", kCellWidth, text.c_str()); }

/// The horizons that fall between two steps, for the note below the table.
std::string interpolation_note(const std::vector<Score>& scores) {
  std::set<std::string> notes;
  for (const Score& score : scores) {
    const int remainder = (score.horizon - score.step) % score.step;
    if (remainder != 0) {
      notes.insert(format("frame %d with step %d lies between frames %d and %d", score.horizon, score.step,
                          score.horizon - remainder, score.horizon - remainder + score.step));
    }
  }
  std::string text;
  for (const std::string& note : notes) {
    text += (text.empty() ? "Interpolated (linear in position, slerp in rotation): " : "; ") + note;
  }
  return text.empty() ? text : text + ".\n";
}

/// One line per row of the table about what rests at the end.
void print_settled(std::ostream& out, const std::vector<Score>& scores) {
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const Score& score = scores[i];
    if ((i > 0 && same_row(scores[i - 1], score)) || score.settled.num_settled == 0) continue;
    out << format("%-14s %6d %5d %-12s", score.set.c_str(), score.start, score.step, score.model.c_str())
        << format(" ends on the right face: %d of %d", score.settled.num_right_face, score.settled.num_settled) << '\n';
  }
}

}  // namespace

void print_scores(std::ostream& out, const std::vector<Score>& scores, HorizonUnit unit) {
  const bool in_frames = unit == HorizonUnit::kFrames;
  std::vector<int> horizons;
  for (const Score& score : scores) {
    if (std::find(horizons.begin(), horizons.end(), score.horizon) == horizons.end()) {
      horizons.push_back(score.horizon);
    }
  }
  out << "Position RMSE [m] / orientation RMSE [deg] / position in % of the size, mean over scenes, "
      << (in_frames ? "h frames" : "h") << " after the start frame.\n"
      << format("%-14s %6s %5s %-12s %6s", "set", "start", "step", "model", "scenes");
  for (const int horizon : horizons) {
    out << padded(in_frames ? "h = " + std::to_string(horizon) : format("h = %.3g s", horizon / 1000.0));
  }
  out << padded("compute s/s") << '\n';
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const Score& score = scores[i];
    if (i == 0 || !same_row(scores[i - 1], score)) {
      out << format("%-14s %6d %5d %-12s %6d", score.set.c_str(), score.start, score.step, score.model.c_str(),
                    score.num_scenes);
    }
    out << padded(cell(score));
    if (i + 1 == scores.size() || !same_row(score, scores[i + 1])) {
      out << padded(format("%.4f", score.compute_s_per_predicted_s)) << '\n';
    }
  }
  if (in_frames) out << interpolation_note(scores);
  print_settled(out, scores);
}

void write_scores_json(const std::filesystem::path& path, const std::vector<Score>& scores,
                       const ProtocolOptions& protocol) {
  const ObservationOptions& observation = protocol.observation;
  nlohmann::json document;
  document["conditions"] = {
      {"points", observation.num_points == 0 ? nlohmann::json("vertices") : nlohmann::json(observation.num_points)},
      {"properties", observation.known_properties ? "known" : "unknown"},
      {"friction", observation.friction ? nlohmann::json(*observation.friction) : nlohmann::json()},
      {"restitution", observation.restitution ? nlohmann::json(*observation.restitution) : nlohmann::json()},
      {"noise_m", observation.noise_m},
      {"masked_fraction", observation.masked_fraction},
      {"one_view", observation.one_view},
      {"resting_only", protocol.resting_only}};
  document["results"] = nlohmann::json::array();
  for (const Score& score : scores) {
    document["results"].push_back(
        {{"model", score.model},
         {"set", score.set},
         {"start", score.start},
         {"step", score.step},
         {protocol.horizon_unit == HorizonUnit::kFrames ? "horizon" : "horizon_ms", score.horizon},
         {"scenes", score.num_scenes},
         {"position_rmse_m", score.error.position_rmse_m},
         {"orientation_rmse_deg", score.error.orientation_rmse_deg},
         {"position_rmse_sizes", score.error.position_rmse_sizes},
         {"settled", score.settled.num_settled},
         {"right_face", score.settled.num_right_face},
         {"compute_s_per_predicted_s", score.compute_s_per_predicted_s}});
  }
  save_text_file(path, document.dump(2) + '\n');
}

}  // namespace rigidformer
