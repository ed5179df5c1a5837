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

namespace rigidformer {

/// All scenes of a run on the device that learns, ready to draw windows from.
struct TrainingData {
  SceneTensors training;
  std::shared_ptr<const WindowSampler> sampler;
  std::vector<std::pair<std::string, SceneTensors>> validation;                 ///< By folder name
  std::vector<std::pair<std::string, std::vector<Window>>> validation_windows;  ///< Of the first folder, by kind
  TrainingFacts facts;                                                          ///< Data, ranges of sizes and speeds
  std::string summary;                                                          ///< For the terminal
};

TrainingData load_training_data(const TrainingPaths& paths, const TrainingOptions& options,
                                const torch::Device& device);

}  // namespace rigidformer
