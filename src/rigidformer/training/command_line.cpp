// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/command_line.hpp"

#include <exception>

#include "rigidformer/training/options.hpp"

namespace rigidformer {

int run_train(const TrainCommand& command, std::ostream& log) {
  try {
    TrainingOptions options = load_training_options(command.config, command.overrides);
    if (command.iterations > 0) options.iterations = command.iterations;
    train(options, command.paths, command.machine);
    return 0;
  } catch (const std::exception& exception) {
    log << "train: " << exception.what() << std::endl;
    return 1;
  }
}

}  // namespace rigidformer
