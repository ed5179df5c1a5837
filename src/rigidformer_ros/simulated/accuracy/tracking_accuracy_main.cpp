// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "rigidformer_ros/node/prediction_node.hpp"
#include "rigidformer_ros/simulated/accuracy/tracking_accuracy.hpp"
#include "rigidformer_ros/simulated/camera/camera_command_line.hpp"

int main(int argc, char** argv) {
  rigidformer_ros::camera::AccuracyOptions options;
  options.camera.num_scenes = 10;
  options.camera.duration = 2.0;
  options.camera.seed = 20250;
  rigidformer_ros::NodeParameters parameters;
  CLI::App app{"Plays simulated scenes through the node's tracking and forecasting and prints their errors."};
  rigidformer_ros::camera::add_camera_options(app, options.camera);
  app.add_option("--methods", options.methods, "Values of correspondence/method")->capture_default_str();
  app.add_option("--model", parameters.model.file, "Checkpoint")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    const auto forecaster =
        rigidformer_ros::camera::make_ready_forecaster(parameters, rigidformer_ros::load_model(parameters.model));
    const auto methods = rigidformer_ros::camera::measure_accuracy(options, parameters, *forecaster);
    std::cout << rigidformer_ros::camera::accuracy_table(methods, options);
  } catch (const std::exception& error) {
    std::cerr << "tracking_accuracy: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
