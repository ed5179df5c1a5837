// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/training/options.hpp"
#include "rigidformer/training/trainer.hpp"
#include "rigidformer/windows/window_sampler.hpp"

namespace rigidformer {

/// All scenes of a run, on the device that learns, ready to draw windows from.
struct TrainingData {
  SceneTensors training;
  std::shared_ptr<const WindowSampler> sampler;
  std::vector<std::pair<std::string, SceneTensors>> validation;  ///< Scenes by name of their folder
  /// Windows of the first folder, by kind.
  std::vector<std::pair<std::string, std::vector<Window>>> validation_windows;
  TrainingFacts facts;  ///< Data and ranges of sizes and speeds, for the checkpoint
  std::string summary;  ///< Text for the terminal
};

TrainingData load_training_data(const TrainingPaths& paths, const TrainingOptions& options,
                                const torch::Device& device);

}  // namespace rigidformer
