// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>

#include "rigidformer/model/summary.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Prints what a RigidFormer model is and what it was trained on."};
  std::string file, preset;
  auto* file_option = app.add_option("file", file, "Checkpoint (*.safetensors)");
  app.add_option("--preset", preset, "Parameter counts of a preset: paper, base, small, tiny")->excludes(file_option);
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << (preset.empty() ? rigidformer::summarize_checkpoint(file) : rigidformer::summarize_preset(preset));
    return 0;
  } catch (const std::exception& exception) {
    std::cerr << "model_info: " << exception.what() << std::endl;
    return 1;
  }
}
