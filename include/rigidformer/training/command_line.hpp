// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "rigidformer/training/trainer.hpp"

namespace rigidformer {

/// The command line of the `train` tool.
struct TrainCommand {
  std::filesystem::path config;
  std::vector<std::string> overrides;  ///< "key=value" that go before the training file, see load_training_options()
  TrainingPaths paths;
  TrainingMachine machine;
  std::string length_scale = "1";  ///< A number above 0, or auto; goes into paths
  std::int64_t iterations = 0;     ///< Number of iterations; 0 = as in the training file
};

/// The keys of a training file with defaults, accepted values and meanings.
std::string training_keys();

/// Runs it; errors become one line on `log` and exit status 1.
int run_train(const TrainCommand& command, std::ostream& log);

}  // namespace rigidformer
