// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/report_folder.hpp"

#include <algorithm>
#include <stdexcept>

#include "report_tables.hpp"
#include "rigidformer/evaluation/plots.hpp"
#include "rigidformer/evaluation/report.hpp"
#include "rigidformer/io/text_file.hpp"

namespace rigidformer {
namespace {

constexpr int kWorstPerStart = 3;
constexpr int kShortPlot = 100;  // [frames], the published horizons, or [ms]
constexpr const char* kNoPicture = "No picture: gnuplot is not installed.\n\n";

int longest(const std::vector<int>& horizons) { return *std::max_element(horizons.begin(), horizons.end()); }

/// Safe in a file name and in a Markdown link whatever the set or scene is called.
std::string file_name(std::string text) {
  for (char& letter : text) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
    letter = plain ? letter : '_';
  }
  return text + ".svg";
}

std::string picture(const std::string& file) { return "![" + file + "](" + file + ")\n\n"; }

std::string error_plots(const std::filesystem::path& folder,
                        const std::map<RoundKey, std::map<int, PartialScore>>& by_frame, HorizonUnit unit) {
  std::map<RoundKey, ErrorCurves> plots;  // without the model in the key
  for (const auto& [key, frames] : by_frame) {
    plots[{key.set, key.start, key.step, ""}][key.model] = frames;
  }
  std::string text;
  for (const auto& [key, curves] : plots) {
    const std::string name =
        "error_" + key.set + "_start_" + std::to_string(key.start) + "_step_" + std::to_string(key.step);
    const std::string title = key.set + ", start " + std::to_string(key.start) + ", step " + std::to_string(key.step);
    int last_frame = 0;
    for (const auto& [model, frames] : curves) {
      last_frame = std::max(last_frame, frames.rbegin()->first);
    }
    for (const int end : {std::min(kShortPlot, last_frame), last_frame}) {
      const std::string file = file_name(name + "_to_" + std::to_string(end));
      text += plot_error_curves(folder / file, title, curves, end, unit) ? picture(file) : kNoPicture;
      if (end == last_frame) break;
    }
  }
  return text;
}

std::string worst_scenes(const std::filesystem::path& folder, const std::vector<ScenePaths>& scenes) {
  std::string text;
  for (const ScenePaths& scene : scenes) {
    const std::string file =
        file_name("worst_" + scene.set + "_start_" + std::to_string(scene.start) + "_scene_" + scene.scene);
    text += worst_scene_line(scene);
    text += plot_paths(folder / file, scene) ? picture(file) : kNoPicture;
  }
  return text;
}

}  // namespace

ReportFolder::ReportFolder(const std::filesystem::path& folder, const std::string& first_model,
                           const ProtocolOptions& options)
    : folder_(folder),
      first_model_(first_model),
      options_(options),
      worst_(first_model, longest(options.horizons), kWorstPerStart, options.horizon_unit) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    throw std::runtime_error("cannot make the report folder " + folder.string() + ": " + failure.message());
  }
}

void ReportFolder::add(const SceneResult& result) {
  breakdown_.add(result);
  worst_.add(result);
}

void ReportFolder::write(const std::vector<Score>& scores) const {
  write_scores_json(folder_ / "scores.json", scores, options_);
  const nlohmann::json parts = {{"by_shape", partial_json("shape", breakdown_.by_shape())},
                                {"by_num_objects", partial_json("num_objects", breakdown_.by_num_objects())},
                                {"by_frame", partial_json(unit_name(options_.horizon_unit), breakdown_.by_frame())}};
  save_text_file(folder_ / "breakdown.json", parts.dump(2) + '\n');
  const std::string frame = " at " + horizon_text(longest(options_.horizons), options_.horizon_unit);
  std::ostringstream report;
  report << "# Scores on recorded scenes\n\n"
         << conditions_text(options_) << "\n## Scores\n\n"
         << score_table(scores) << settled_table(scores);
  report << "\n## Error over time\n\nMean over scenes of the error per scene.\n\n"
         << error_plots(folder_, breakdown_.by_frame(), options_.horizon_unit);
  report << "## By shape," << frame << "\n\nRoot mean square over all objects of a shape.\n\n"
         << partial_table("shape", "objects", breakdown_.by_shape());
  report << "\n## By number of objects," << frame << "\n\nMean over scenes of the error per scene.\n\n"
         << partial_table("objects in the scene", "scenes", breakdown_.by_num_objects());
  report << "\n## Worst scenes of " << first_model_ << "," << frame << "\n\n"
         << "Per set and start, by position; paths from the second given frame on.\n\n"
         << worst_scenes(folder_, worst_.list());
  save_text_file(folder_ / "report.md", report.str());
}

}  // namespace rigidformer
