// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <thread>

#include "rigidformer/simulation/dataset_generator.hpp"

int main(int argc, char** argv) {
  rigidformer::DatasetOptions options;
  options.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App app{"Simulates MOVi scenes (objects thrown into a box, falling on a plane) with Bullet or MuJoCo."};
  app.add_option("--set", options.set, "movi_sphere | movi_a | movi_b")->required();
  app.add_option("--scenes", options.num_scenes, "Number of scenes")->required();
  app.add_option("--frames", options.movi.num_frames, "Frames of 1/240 s to record")->capture_default_str();
  app.add_option("--first-frame", options.movi.first_frame,
                 "Frames simulated before the recording begins; after 720 or more most objects rest or roll")
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Same seed, same scenes")->capture_default_str();
  app.add_option("--out", options.output, "Output folder")->required();
  app.add_option("--shapes", options.shapes, "Shapes in KuBasic layout; default: built-in shapes");
  app.add_option("--engine", options.engine, "bullet | mujoco")->capture_default_str();
  app.add_option("--contacts", options.contacts,
                 "movi | varied: other materials, floors, sizes, gravity and solvers in every scene")
      ->capture_default_str();
  app.add_option("--format", options.format, "archive | kubric")->capture_default_str();
  app.add_option("--jobs", options.jobs, "Threads")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    rigidformer::generate_dataset(options, std::cerr);
  } catch (const std::exception& exception) {
    std::cerr << "generate_scenes: " << exception.what() << '\n';
    return 1;
  }
  return 0;
}
