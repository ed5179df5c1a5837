// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <thread>

#include "rigidformer/simulation/dataset_generator.hpp"
#include "rigidformer/simulation/scene_set.hpp"

int main(int argc, char** argv) {
  rigidformer::DatasetOptions options;
  options.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  int num_frames = 0;
  CLI::App app{
      "Simulates scenes with Bullet or MuJoCo: objects that fall (movi), a ball that hits a wall of cubes, walkers "
      "that follow "
      "commands."};
  app.add_option("--set", options.set, "Kind of scenes")
      ->required()
      ->check(CLI::IsMember(rigidformer::scene_set_names()));
  app.add_option("--scenes", options.num_scenes, "Number of scenes")->required();
  app.add_option("--frames", num_frames, "Frames to record; default: 480 (movi), 600 (wrecking ball), 300 (walkers)")
      ->check(CLI::PositiveNumber);
  app.add_option("--first-frame", options.movi.first_frame,
                 "Frames simulated before the recording begins; after 720 or more most objects rest or roll")
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Same seed, same scenes")->capture_default_str();
  app.add_option("--out", options.output, "Output folder")->required();
  app.add_option("--shapes", options.shapes, "Shapes of MOVi scenes in KuBasic layout; default: built-in ones");
  app.add_option("--engine", options.engine, "bullet | mujoco (MOVi scenes only)")->capture_default_str();
  app.add_option("--contacts", options.contacts,
                 "movi | varied: other materials, floors, sizes, gravity and solvers in every scene")
      ->capture_default_str();
  app.add_flag("--fixtures", options.fixtures,
               "Static fixtures (tables, shelves, bins, walls, ramps, pegs) and driven pushers, palms and grippers "
               "(MOVi scenes only)");
  app.add_option("--format", options.format, "archive | kubric")->capture_default_str();
  app.add_option("--jobs", options.jobs, "Threads")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  options.movi.num_frames = num_frames > 0 ? num_frames : rigidformer::usual_num_frames(options.set);
  try {
    rigidformer::generate_dataset(options, std::cerr);
  } catch (const std::exception& exception) {
    std::cerr << "generate_scenes: " << exception.what() << '\n';
    return 1;
  }
  return 0;
}
