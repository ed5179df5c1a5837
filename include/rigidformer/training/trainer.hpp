// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rigidformer {

struct TrainingOptions;  // defined in training/options.hpp, which needs LibTorch's headers

/// Where a training run reads and writes.
struct TrainingPaths {
  std::vector<std::filesystem::path> data;        ///< Folders or archives of scenes to learn from
  std::vector<std::filesystem::path> validation;  ///< Scenes that are never learned from; may be empty
  std::filesystem::path shapes;                   ///< Shape library for Kubric folders; may be empty
  std::filesystem::path output;                   ///< Folder for the state, model.safetensors, log.csv and loss.svg
  std::filesystem::path initial_model;            ///< Weights to start from; may be empty
  /// Real lengths of all scenes over those to learn from; none = from the sizes that the initial model was trained on.
  std::optional<double> length_scale = 1.0;
};

/// How a training run uses the machine.
struct TrainingMachine {
  std::string device = "auto";  ///< auto | cpu | cuda | cuda:N
  int num_threads = 1;
  double max_minutes = 0.0;  ///< Minutes after which the run stops, to be resumed; 0 = no limit
  bool resume = false;       ///< Goes on exactly from the state in the output folder
  /// Asked after every iteration: true = save and stop, to be resumed. May be empty.
  std::function<bool()> should_stop = {};
};

/// Trains until all iterations are done or time is up. Throws std::invalid_argument or std::runtime_error.
void train(const TrainingOptions& options, const TrainingPaths& paths, const TrainingMachine& machine);

}  // namespace rigidformer
