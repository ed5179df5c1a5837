// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rigidformer/data/scene_loader.hpp"
#include "rigidformer/evaluation/ballistic.hpp"
#include "rigidformer/evaluation/model_forecaster.hpp"
#include "rigidformer/evaluation/protocol.hpp"
#include "rigidformer/evaluation/report.hpp"

namespace {

using namespace rigidformer;

struct Arguments {
  PredictorOptions model;
  std::vector<std::string> data;
  std::string shapes_dir;
  std::vector<std::string> baselines{"ballistic"};
  std::string points = "256";
  std::string properties = "known";
  std::string json_file;
  ProtocolOptions protocol;
};

/// The checkpoint that comes with the package: of the installation that holds this program, else of the source tree.
std::string shipped_model() {
  namespace fs = std::filesystem;
  const fs::path file = fs::path("models") / "small.safetensors";
  const fs::path program = fs::read_symlink("/proc/self/exe");
  for (fs::path folder = program.parent_path(); folder != folder.parent_path(); folder = folder.parent_path()) {
    const fs::path installed = folder / "share" / "rigidformer_ros" / file;
    if (fs::exists(installed)) {
      return installed.string();
    }
  }
  return (fs::path(RIGIDFORMER_SOURCE_DIR) / file).string();
}

void add_options(CLI::App& app, Arguments& arguments) {
  ProtocolOptions& protocol = arguments.protocol;
  app.add_option("--model", arguments.model.file, "Checkpoint; 'none' scores the baselines alone [the shipped one]");
  app.add_option("--device", arguments.model.device, "auto, cpu, cuda or cuda:N")->capture_default_str();
  app.add_option("--precision", arguments.model.precision, "float32 or bfloat16")->capture_default_str();
  app.add_option("--threads", arguments.model.num_threads, "CPU threads")->capture_default_str();
  app.add_option("--data", arguments.data, "One set of scenes each: archive, archive shards or Kubric folders")
      ->required();
  app.add_option("--shapes", arguments.shapes_dir, "Meshes of the shapes in KuBasic layout, for Kubric folders");
  app.add_option("--starts", protocol.starts, "First given frames")->delimiter(',')->capture_default_str();
  app.add_option("--steps", protocol.steps, "Frames per step")->delimiter(',')->capture_default_str();
  app.add_option("--horizons", protocol.horizons, "Frames after the start that are scored")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--scenes", protocol.max_scenes, "Scenes per set, 0 = all")->capture_default_str();
  app.add_option("--baselines", arguments.baselines, "Scored beside the model: ballistic or none")
      ->delimiter(',')
      ->check(CLI::IsMember({"ballistic", "none"}))
      ->capture_default_str();
  app.add_option("--points", arguments.points, "Surface samples per object, or 'vertices'")
      ->check(CLI::Range(4, 1000000) | CLI::IsMember({"vertices"}))
      ->capture_default_str();
  app.add_option("--properties", arguments.properties, "Mass, friction and restitution are known or unknown")
      ->check(CLI::IsMember({"known", "unknown"}))
      ->capture_default_str();
  app.add_option("--noise", protocol.observation.noise_m, "Standard deviation of the points [m]")
      ->capture_default_str();
  app.add_option("--mask", protocol.observation.masked_fraction, "Share of the points dropped at random")
      ->capture_default_str();
  app.add_flag("--view", protocol.observation.one_view, "Keep only points that face one camera");
  app.add_option("--json", arguments.json_file, "Also write the scores to this file");
}

/// Options whose text is not their value.
void resolve(Arguments& arguments) {
  ObservationOptions& observation = arguments.protocol.observation;
  observation.num_points = arguments.points == "vertices" ? 0 : std::stoi(arguments.points);
  observation.known_properties = arguments.properties == "known";
  if (arguments.model.file.empty()) {
    arguments.model.file = shipped_model();
  }
  arguments.protocol.validate();
}

/// One line on stderr, renewed at most once a second: share done and the time left at the mean pace so far.
class ProgressLine {
 public:
  explicit ProgressLine(std::string label) : label_(std::move(label)) {}

  void operator()(long done, long total) {
    const Clock::time_point now = Clock::now();
    if (done < total && now - shown_ < std::chrono::seconds(1)) {
      return;
    }
    shown_ = now;
    const double elapsed_s = std::chrono::duration<double>(now - begin_).count();
    const double left_s = elapsed_s * static_cast<double>(total - done) / static_cast<double>(done);
    std::fprintf(stderr, "\r%s: %3ld %%, %.0f s done, %.0f s left   %s", label_.c_str(), 100 * done / total, elapsed_s,
                 left_s, done == total ? "\n" : "");
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  Clock::time_point begin_ = Clock::now(), shown_ = begin_;
};

void run(const Arguments& arguments) {
  std::unique_ptr<Predictor> predictor;
  std::vector<std::unique_ptr<Forecaster>> forecasters;
  if (arguments.model.file != "none") {
    predictor = std::make_unique<Predictor>(arguments.model);
    predictor->warm_up();
    forecasters.push_back(std::make_unique<ModelForecaster>(*predictor));
  }
  for (const std::string& baseline : arguments.baselines) {
    if (baseline == "ballistic") {
      forecasters.push_back(std::make_unique<BallisticForecaster>());
    }
  }
  std::vector<Forecaster*> contestants;
  for (const auto& forecaster : forecasters) {
    contestants.push_back(forecaster.get());
  }
  std::vector<Score> scores;
  for (const std::string& path : arguments.data) {
    const std::filesystem::path shapes_dir = arguments.shapes_dir;
    const SceneArchive archive = load_scenes(path, shapes_dir, arguments.protocol.max_scenes);
    const auto of_set = evaluate(archive, contestants, arguments.protocol, ProgressLine(archive.set));
    scores.insert(scores.end(), of_set.begin(), of_set.end());
  }
  print_scores(std::cout, scores);
  if (!arguments.json_file.empty()) {
    write_scores_json(arguments.json_file, scores, arguments.protocol.observation);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Scores a model on recorded scenes beside what simpler forecasters make of the same observations.");
  Arguments arguments;
  add_options(app, arguments);
  CLI11_PARSE(app, argc, argv);
  resolve(arguments);
  run(arguments);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "evaluate: %s\n", error.what());
  return 1;
}
