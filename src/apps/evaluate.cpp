// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "evaluate_options.hpp"
#include "rigidformer/baselines/physics_engine.hpp"
#include "rigidformer/data/scene_loader.hpp"
#include "rigidformer/evaluation/ballistic.hpp"
#include "rigidformer/evaluation/length_scaled_forecaster.hpp"
#include "rigidformer/evaluation/model_forecaster.hpp"
#include "rigidformer/evaluation/protocol.hpp"
#include "rigidformer/evaluation/report.hpp"
#include "rigidformer/evaluation/report_folder.hpp"
#include "rigidformer/evaluation/scene_error_table.hpp"
#include "rigidformer/length_scale.hpp"
#include "rigidformer/model/threads.hpp"

namespace {

using namespace rigidformer;

constexpr int kReportFrames = 240, kReport_ms = 2000;  // how far a report follows the error

/// Share done and the time left at the mean pace so far, on stderr: one line renewed every second on a terminal, a new
/// line every half minute in a log.
class ProgressLine {
 public:
  explicit ProgressLine(std::string label) : label_(std::move(label)) {}

  void operator()(long done, long total) {
    const Clock::time_point now = Clock::now();
    if (done < total && now - shown_ < std::chrono::seconds(is_terminal_ ? 1 : 30)) {
      return;
    }
    shown_ = now;
    const double elapsed_s = std::chrono::duration<double>(now - begin_).count();
    const double left_s = elapsed_s * static_cast<double>(total - done) / static_cast<double>(done);
    std::fprintf(stderr, "%s%s: %3ld %%, %.0f s done, %.0f s left   %s", is_terminal_ ? "\r" : "", label_.c_str(),
                 100 * done / total, elapsed_s, left_s, done == total || !is_terminal_ ? "\n" : "");
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  bool is_terminal_ = isatty(STDERR_FILENO) != 0;
  Clock::time_point begin_ = Clock::now(), shown_ = begin_;
};

/// The model first, then the baselines in the order asked for.
std::vector<std::unique_ptr<Forecaster>> make_forecasters(const EvaluateOptions& options, Predictor* predictor) {
  std::vector<std::unique_ptr<Forecaster>> forecasters;
  if (predictor != nullptr) {
    forecasters.push_back(std::make_unique<ModelForecaster>(*predictor));
  }
  for (const std::string& baseline : options.baselines) {
    if (baseline == "ballistic") {
      forecasters.push_back(std::make_unique<BallisticForecaster>());
    } else if (baseline != "none") {
      forecasters.push_back(make_physics_engine(baseline));
    }
  }
  return forecasters;
}

/// Real lengths over trained ones for the objects of a set.
double length_scale_of(const EvaluateOptions& options, const SceneArchive& archive, const Predictor* predictor) {
  if (options.length_scale) return *options.length_scale;
  if (predictor == nullptr) throw std::invalid_argument("--length-scale auto needs a model, whose sizes it goes by");
  const double scale = automatic_length_scale(archive, predictor->info().min_size_m, predictor->info().max_size_m);
  std::fprintf(stderr, "evaluate: set %s has length scale %.4g\n", archive.set.c_str(), scale);
  return scale;
}

/// Scores one set at its scale. The camera comes as much closer as the objects are smaller.
std::vector<Score> score_set(const SceneArchive& archive, const std::vector<Forecaster*>& contestants, double scale,
                             ProtocolOptions protocol, const ResultSink& sink) {
  protocol.observation.camera_world *= scale;
  std::vector<std::unique_ptr<Forecaster>> scaled;
  std::vector<Forecaster*> at_scale;
  for (Forecaster* contestant : contestants) {
    scaled.push_back(std::make_unique<LengthScaledForecaster>(*contestant, scale));
    at_scale.push_back(scaled.back().get());
  }
  return evaluate(archive, at_scale, protocol, ProgressLine(archive.set), sink);
}

/// Scores of all sets; with the report and the table of scenes on the way, where asked for.
std::vector<Score> score_sets(const EvaluateOptions& options, const std::vector<Forecaster*>& contestants,
                              const Predictor* predictor) {
  ProtocolOptions protocol = options.protocol;
  std::unique_ptr<ReportFolder> report;
  if (!options.report_dir.empty()) {
    protocol.curve_end = protocol.horizon_unit == HorizonUnit::kFrames ? kReportFrames : kReport_ms;
    protocol.to_the_end = true;
    report = std::make_unique<ReportFolder>(options.report_dir, contestants.front()->name(), protocol);
  }
  SceneErrorTable table(protocol);
  const ResultSink sink = [&](const SceneResult& result) {
    if (report) report->add(result);
    table.add(result);
  };
  std::vector<Score> scores;
  for (const std::string& path : options.data) {
    const std::filesystem::path shapes_dir = options.shapes_dir;
    const SceneArchive archive = load_scenes(path, shapes_dir, protocol.max_scenes);
    for (const std::string& sentence : scenes_left_out(archive, protocol)) {
      std::fprintf(stderr, "evaluate: %s\n", sentence.c_str());
    }
    const double scale = length_scale_of(options, archive, predictor);
    const auto of_set = score_set(archive, contestants, scale, protocol, sink);
    scores.insert(scores.end(), of_set.begin(), of_set.end());
  }
  if (report) {
    report->write(scores);
  }
  if (!options.scene_errors_file.empty()) table.write(options.scene_errors_file);
  return scores;
}

void run(const EvaluateOptions& options) {
  std::unique_ptr<Predictor> predictor;
  if (options.model.file != "none") {
    predictor = std::make_unique<Predictor>(options.model);
    predictor->warm_up();
  }
  const auto forecasters = make_forecasters(options, predictor.get());
  if (forecasters.empty()) {
    throw std::invalid_argument("nothing to score: the model and the baselines are 'none'");
  }
  std::vector<Forecaster*> contestants;
  for (const auto& forecaster : forecasters) {
    contestants.push_back(forecaster.get());
  }
  const std::vector<Score> scores = score_sets(options, contestants, predictor.get());
  print_scores(std::cout, scores, options.protocol.horizon_unit);
  if (!options.json_file.empty()) {
    write_scores_json(options.json_file, scores, options.protocol);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  use_vector_units();
  run(read_command_line(argc, argv));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "evaluate: %s\n", error.what());
  return 1;
}
