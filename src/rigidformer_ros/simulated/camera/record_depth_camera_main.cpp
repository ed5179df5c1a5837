// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "rigidformer_ros/simulated/camera/camera_command_line.hpp"
#include "rigidformer_ros/simulated/camera/depth_camera_recorder.hpp"

int main(int argc, char** argv) {
  rigidformer_ros::camera::CameraOptions options;
  std::string file;
  CLI::App app{"Records what the simulated depth camera sees into a bag."};
  app.add_option("bag", file, "Bag to write")->required();
  rigidformer_ros::camera::add_camera_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    const auto summary = rigidformer_ros::camera::record_bag(file, options);
    std::cout << file << ": " << summary.num_scenes << " scenes, " << summary.num_frames << " frames\n";
  } catch (const std::exception& error) {
    std::cerr << "record_depth_camera: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
