// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rigidformer/model/options.hpp"
#include "rigidformer/windows/window_batch.hpp"
#include "rigidformer/windows/window_sampler.hpp"

namespace rigidformer {

/// Number of unrolled steps from a given share of the training on.
struct UnrollStage {
  double from = 0.0;  ///< Share of all iterations, in [0, 1]
  int steps = 1;      ///< 0 = learn what is seen (centre of mass, hidden side), not how it moves
};

/// §3.4 and App. C.2. Field names are the YAML keys under `loss:`.
struct LossOptions {
  double position_weight = 10.0;      ///< lambda_pos
  double acceleration_weight = 1.0;   ///< lambda_acc
  double end_velocity_weight = 1.0;   ///< Smooth L1 of the velocity at the end of the step, where the model predicts it
  std::string residual_unit = "dt2";  ///< Acceleration residuals divided by dt2 (paper) or dt (velocity change)
  double beta = 1.0;                  ///< Where Smooth L1 turns from square to line
  double centre_of_mass_weight = 0.0;  ///< Smooth L1 of the estimated centre of mass, in bounding radii
  double hidden_side_weight = 1.0;     ///< Smooth L1 of the completed hull's extent, in bounding radii
};

/// App. C.1. Field names are the YAML keys under `optimizer:`.
struct OptimizerOptions {
  double learning_rate = 1e-4;
  double final_learning_rate = 1e-6;  ///< End of the cosine
  double warmup = 0.033;              ///< Share of all iterations, linear from 10 % of the rate
  double weight_decay = 0.01;
  double beta1 = 0.9, beta2 = 0.999;
  double clip_norm = 1.0;
  double ema_decay = 0.0;  ///< Weight averaging; 0 = off
};

/// Everything that defines a training run. Sections of the YAML file are the members of this struct.
struct TrainingOptions {
  ModelOptions model;
  WindowOptions windows;
  AugmentationOptions augmentation;
  PointSetOptions point_sets;
  LossOptions loss;
  OptimizerOptions optimizer;
  std::vector<UnrollStage> unroll = {{0.0, 1}};
  std::int64_t iterations = 1000;
  int batch_size = 18;    ///< Windows per micro-batch
  int micro_batches = 1;  ///< Per iteration, over all processes: their gradients are averaged
  std::uint64_t seed = 0;
  std::string precision = "float32";  ///< Of the activations: float32 | bfloat16
  int log_every = 50;                 ///< Iterations between log lines
  double checkpoint_every_s = 180.0;
  double validate_every_s = 300.0;
  int validation_scenes = 30;  ///< Per archive folder, for rollouts
};

/// Reads a YAML file; keys left out keep their default (the model's preset for `model:`). `overrides` go before the
/// file, each "key=value" or "section.key=value" with a value in YAML. Throws std::invalid_argument naming file, key
/// and accepted values for unknown keys, wrong types and values out of range.
TrainingOptions load_training_options(const std::filesystem::path& file,
                                      const std::vector<std::string>& overrides = {});

}  // namespace rigidformer
