// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>

#include "rigidformer/model/threads.hpp"
#include "rigidformer/training/command_line.hpp"

int main(int argc, char** argv) {
  rigidformer::use_vector_units();
  CLI::App app{"Trains a RigidFormer model on simulated or recorded scenes."};
  rigidformer::TrainCommand command;
  app.add_option("--config", command.config, "Training file, see config/train/")->required()->check(CLI::ExistingFile);
  app.add_option("--set", command.overrides, "KEY=VALUE or SECTION.KEY=VALUE instead of what the training file says")
      ->allow_extra_args(false);
  app.add_option("--data", command.paths.data, "Folders of scenes to learn from")->required();
  app.add_option("--validation", command.paths.validation, "Folders of scenes never learned from");
  app.add_option("--shapes", command.paths.shapes, "Shape library for Kubric folders");
  app.add_option("--out", command.paths.output, "Output folder")->required();
  app.add_option("--init", command.paths.initial_model,
                 "Start from the weights of this model; what the new one has beyond it starts at zero");
  app.add_option(
         "--length-scale", command.length_scale,
         "Real lengths over those to learn from: lengths are divided by it, frame rates multiplied by its root; "
         "auto = from the objects and the sizes that the model of --init was trained on")
      ->capture_default_str();
  app.add_option("--device", command.machine.device, "auto, cpu, cuda or cuda:N")->capture_default_str();
  app.add_option("--threads", command.machine.num_threads, "CPU threads of tensor operations")->capture_default_str();
  app.add_option("--iterations", command.iterations, "Instead of the number in the training file");
  app.add_option("--max-minutes", command.machine.max_minutes, "Stop, resumably, after this time");
  app.add_flag("--resume", command.machine.resume, "Go on exactly from the state in --out");
  app.footer(rigidformer::training_keys());
  CLI11_PARSE(app, argc, argv);
  return rigidformer::run_train(command, std::cerr);
}
