// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// This example shows the whole learning half in seconds on a CPU: it simulates scenes, trains the tiny network and
// scores it. The command-line tools do the same:
//   generate_scenes --set movi_a --scenes 12 --seed 7 --out DIR/scenes
//   train --config config/train/tiny.yaml --data DIR/scenes --out DIR/run
//   evaluate --model DIR/run/model.safetensors --data DIR/scenes --starts 120 --steps 10 --horizons 50,100
// The network sees only a few hundred windows, so its score is poor.
#include <filesystem>
#include <iostream>

#include "rigidformer/data/scene_loader.hpp"
#include "rigidformer/evaluation/ballistic.hpp"
#include "rigidformer/evaluation/model_forecaster.hpp"
#include "rigidformer/evaluation/protocol.hpp"
#include "rigidformer/evaluation/report.hpp"
#include "rigidformer/simulation/dataset_generator.hpp"
#include "rigidformer/training/command_line.hpp"

namespace {

using namespace rigidformer;
namespace fs = std::filesystem;

void generate(const fs::path& scenes) {
  DatasetOptions options;
  options.set = "movi_a";
  options.num_scenes = 12;
  options.seed = 7;
  options.output = scenes;
  generate_dataset(options, std::cerr);
}

bool learn(const fs::path& scenes, const fs::path& run) {
  TrainCommand command;
  command.config = RIGIDFORMER_SOURCE_DIR "/config/train/tiny.yaml";
  command.paths.data = {scenes};
  command.paths.output = run;
  command.machine.device = "cpu";
  return run_train(command, std::cerr) == 0;
}

std::vector<Score> score(const fs::path& scenes, const fs::path& model) {
  PredictorOptions options;
  options.file = model;
  options.device = "cpu";
  Predictor predictor(options);
  ModelForecaster network(predictor);
  BallisticForecaster ballistic;
  ProtocolOptions protocol;
  protocol.starts = {120};
  protocol.steps = {10};
  protocol.horizons = {50, 100};
  return evaluate(load_scenes(scenes, fs::path()), {&network, &ballistic}, protocol);
}

}  // namespace

int main(int argc, char** argv) try {
  const fs::path scratch = fs::temp_directory_path() / "rigidformer_train_tiny";
  fs::remove_all(scratch);
  const fs::path folder = argc > 1 ? fs::path(argv[1]) : scratch;
  generate(folder / "scenes");
  if (!learn(folder / "scenes", folder / "run")) return 1;
  const std::vector<Score> scores = score(folder / "scenes", folder / "run" / "model.safetensors");
  print_scores(std::cout, scores);
  std::cout << "everything lies in " << folder << '\n';
  for (const Score& entry : scores) {
    // Scenes fit into a box of 10 m, so a larger error means that a rollout has exploded.
    if (!(entry.error.position_rmse_m < 10.0)) return 1;
  }
  return scores.empty() ? 1 : 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
