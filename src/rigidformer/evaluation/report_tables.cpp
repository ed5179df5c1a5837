// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "report_tables.hpp"

#include <cstdio>

namespace rigidformer {
namespace {

std::string number(const char* pattern, double value) {
  char text[32];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

}  // namespace

std::string error_columns(const PoseError& error) {
  return number("%.4f", error.position_rmse_m) + " | " + number("%.2f", error.orientation_rmse_deg);
}

std::string unit_name(HorizonUnit unit) { return unit == HorizonUnit::kFrames ? "frame" : "ms"; }

std::string horizon_text(int horizon, HorizonUnit unit) {
  if (unit == HorizonUnit::kFrames) return "frame " + std::to_string(horizon);
  return number("%.3g s", horizon / 1000.0);
}

std::string settled_table(const std::vector<Score>& scores) {
  std::ostringstream text;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const Score& score = scores[i];
    const bool is_told = i > 0 && scores[i - 1].model == score.model && scores[i - 1].set == score.set &&
                         scores[i - 1].start == score.start && scores[i - 1].step == score.step;
    if (is_told || score.settled.num_settled == 0) continue;
    text << "| " << score.set << " | " << score.start << " | " << score.step << " | " << score.model << " | "
         << score.settled.num_settled << " | "
         << number("%.1f", 100.0 * score.settled.num_right_face / score.settled.num_settled) << " |\n";
  }
  if (text.str().empty()) return "";
  return "\nOf the objects that rest at the end of their recording, those that lie on the right face there "
         "(tilted by less than 20 degrees):\n\n"
         "| set | start | step | model | settled | right face % |\n|---|---|---|---|---|---|\n" +
         text.str();
}

std::string conditions_text(const ProtocolOptions& options) {
  const ObservationOptions& seen = options.observation;
  std::ostringstream text;
  text << "Frames `start` and `start + step` are given; errors are root mean squares over the objects of a scene, "
          "`horizon` "
       << (options.horizon_unit == HorizonUnit::kFrames ? "frames" : "milliseconds")
       << " after the start, then means over scenes. Horizons between two steps are interpolated "
          "(linear in position, slerp in rotation).\n\nSeen: "
       << (seen.num_points == 0 ? "the vertices" : std::to_string(seen.num_points) + " surface points") << " per object"
       << (seen.one_view ? ", those that face one camera" : "");
  if (seen.masked_fraction > 0.0) text << ", " << 100.0 * seen.masked_fraction << " % of them dropped";
  text << ", noise " << 1000.0 * seen.noise_m << " mm; mass, friction and restitution "
       << (seen.known_properties ? "known" : "unknown") << ".\n";
  return text.str();
}

std::string score_table(const std::vector<Score>& scores) {
  std::ostringstream text;
  text << "| set | start | step | horizon | model | scenes | position m | orientation deg | position % of size | "
          "compute s/s |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Score& score : scores) {
    text << "| " << score.set << " | " << score.start << " | " << score.step << " | " << score.horizon << " | "
         << score.model << " | " << score.num_scenes << " | " << error_columns(score.error) << " | "
         << number("%.1f", 100.0 * score.error.position_rmse_sizes) << " | "
         << number("%.4f", score.compute_s_per_predicted_s) << " |\n";
  }
  return text.str();
}

std::string worst_scene_line(const ScenePaths& scene) {
  return "- " + scene.set + ", start " + std::to_string(scene.start) + ", scene " + scene.scene + ", step " +
         std::to_string(scene.step) + ", " + std::to_string(scene.shapes.size()) +
         " objects: " + number("%.4f", scene.error.position_rmse_m) + " m, " +
         number("%.2f", scene.error.orientation_rmse_deg) + " deg\n\n";
}

}  // namespace rigidformer
