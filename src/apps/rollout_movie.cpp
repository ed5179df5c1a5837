// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>

#include "rigidformer/data/scene_loader.hpp"
#include "rigidformer/evaluation/model_forecaster.hpp"
#include "rigidformer/evaluation/movie.hpp"

namespace {

struct Options {
  std::string model, data, shapes, gif;
  int scene = 0;
  rigidformer::MovieOptions movie;
};

void run(const Options& options) {
  rigidformer::PredictorOptions model;
  model.file = options.model;
  rigidformer::Predictor predictor(model);
  rigidformer::ModelForecaster forecaster(predictor);
  const auto archive = rigidformer::load_scenes(options.data, std::filesystem::path(options.shapes), options.scene + 1);
  const rigidformer::Observer observer(archive.shapes, {});
  const auto& scene = archive.scenes.at(static_cast<std::size_t>(options.scene));
  if (!rigidformer::draw_movie(options.gif, scene, observer, forecaster, options.movie)) {
    throw std::runtime_error("no picture was made: is gnuplot installed and '" + options.gif + "' writable?");
  }
}

}  // namespace

int main(int argc, char** argv) try {
  Options options;
  CLI::App app("Draws a rollout beside the recorded motion as an animated GIF.");
  app.add_option("--model", options.model, "Checkpoint")->required();
  app.add_option("--data", options.data, "Scenes: archive, archive shards or Kubric folders")->required();
  app.add_option("--shapes", options.shapes, "Meshes of the shapes in KuBasic layout, for Kubric folders");
  app.add_option("--scene", options.scene, "Number of the scene")->check(CLI::NonNegativeNumber)->capture_default_str();
  app.add_option("--start", options.movie.start, "First given frame")->capture_default_str();
  app.add_option("--step", options.movie.step, "Frames per step")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--steps", options.movie.num_steps, "Predicted steps")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--out", options.gif, "GIF file")->required();
  CLI11_PARSE(app, argc, argv);
  run(options);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "rollout_movie: " << error.what() << '\n';
  return 1;
}
