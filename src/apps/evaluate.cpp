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
#include "rigidformer/evaluation/model_forecaster.hpp"
#include "rigidformer/evaluation/protocol.hpp"
#include "rigidformer/evaluation/report.hpp"
#include "rigidformer/evaluation/report_folder.hpp"
#include "rigidformer/model/threads.hpp"

namespace {

using namespace rigidformer;

constexpr int kReportFrames = 240;  // how far a report follows the error

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

/// Scores of all sets; with the report on the way, if one is asked for.
std::vector<Score> score_sets(const EvaluateOptions& options, const std::vector<Forecaster*>& contestants) {
  ProtocolOptions protocol = options.protocol;
  std::unique_ptr<ReportFolder> report;
  ResultSink sink;
  if (!options.report_dir.empty()) {
    protocol.curve_frames = kReportFrames;
    report = std::make_unique<ReportFolder>(options.report_dir, contestants.front()->name(), protocol);
    sink = [&report](const SceneResult& result) { report->add(result); };
  }
  std::vector<Score> scores;
  for (const std::string& path : options.data) {
    const std::filesystem::path shapes_dir = options.shapes_dir;
    const SceneArchive archive = load_scenes(path, shapes_dir, protocol.max_scenes);
    for (const std::string& sentence : scenes_left_out(archive, protocol)) {
      std::fprintf(stderr, "evaluate: %s\n", sentence.c_str());
    }
    const auto of_set = evaluate(archive, contestants, protocol, ProgressLine(archive.set), sink);
    scores.insert(scores.end(), of_set.begin(), of_set.end());
  }
  if (report) {
    report->write(scores);
  }
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
  const std::vector<Score> scores = score_sets(options, contestants);
  print_scores(std::cout, scores);
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
