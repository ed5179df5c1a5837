// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// This program plays real clouds of tables on which nothing moves through the segmentation and the classes of the node,
// and prints how far the forecasts move what stands there.
#include <CLI/CLI.hpp>
#include <iostream>

#include "rigidformer_ros/node/prediction_node.hpp"
#include "rigidformer_ros/simulated/accuracy/tracking_accuracy.hpp"
#include "still_scene.hpp"

namespace {

void play(const std::string& file, StillOptions options, const rigidformer_ros::NodeParameters& parameters,
          rigidformer_ros::SceneForecaster& forecaster) {
  const SegmentationOptions segmentation;
  const StillScene scene = read_still_scene(file, segmentation);
  for (const bool use_labels : {false, true}) {
    if (use_labels && scene.labels.empty()) continue;
    options.use_labels = use_labels;
    std::cout << file << (use_labels ? ", objects by label" : ", objects by segmentation") << '\n'
              << still_table(play_still_scene(scene, options, segmentation, parameters, forecaster)) << std::endl;
  }
}

}  // namespace

int main(int argc, char** argv) {
  StillOptions options;
  std::vector<std::string> files;
  rigidformer_ros::NodeParameters parameters;
  parameters.correspondence.method = rigidformer::Correspondence::kRegistration;  // as bare_depth_camera.launch
  parameters.predict.length_scale.reset();
  CLI::App app{"Plays clouds of scenes in which nothing moves and prints how far the forecasts move them."};
  app.add_option("file", files, "PCD files, with or without labels")->required()->check(CLI::ExistingFile);
  app.add_option("--model", parameters.model.file, "Checkpoint")->capture_default_str();
  app.add_option("--clouds", options.num_clouds, "Clouds of each scene")->capture_default_str();
  app.add_option("--rate", options.rate_hz, "[Hz] of the clouds")->capture_default_str();
  app.add_option("--noise", options.noise_m, "[m] along the rays")->capture_default_str();
  app.add_option("--horizon", options.horizon_s, "[s] of the forecasts")->capture_default_str();
  app.add_option("--seed", options.seed, "Of the noise")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    const auto forecaster =
        rigidformer_ros::camera::make_ready_forecaster(parameters, rigidformer_ros::load_model(parameters.model));
    for (const std::string& file : files) play(file, options, parameters, *forecaster);
  } catch (const std::exception& error) {
    std::cerr << "still_scenes: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
