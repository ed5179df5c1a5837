// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rigidformer/model/options.hpp"
#include "rigidformer/windows/options.hpp"

namespace rigidformer {

/// Number of unrolled steps from a given share of the training on.
struct UnrollStage {
  double from = 0.0;
  int steps = 1;
};

template <typename Visit>
void for_each_member(UnrollStage& o, const Visit& visit) {
  visit("from", o.from, anything(), "share of all iterations, in [0, 1]");
  visit("steps", o.steps, at_least(0), "0 = learn what is seen (centre of mass, hidden side), not how it moves");
}

/// §3.4 and App. C.2. A member's name is its YAML key under `loss:`.
struct LossOptions {
  double position_weight = 10.0;     ///< lambda_pos
  double acceleration_weight = 1.0;  ///< lambda_acc
  double end_velocity_weight = 1.0;
  std::string residual_unit = "dt2";
  double beta = 1.0;
  double centre_of_mass_weight = 0.0;
  double hidden_side_weight = 1.0;
};

template <typename Visit>
void for_each_member(LossOptions& o, const Visit& visit) {
  visit("position_weight", o.position_weight, anything(), "lambda_pos");
  visit("acceleration_weight", o.acceleration_weight, anything(), "lambda_acc");
  visit("end_velocity_weight", o.end_velocity_weight, anything(),
        "Smooth L1 of the velocity at the end of the step, where the model predicts it");
  visit("residual_unit", o.residual_unit, one_of({"dt", "dt2", "frames2"}),
        "acceleration residuals are those of positions divided by dt2 in s^2, by dt in s (velocity change), or by s^2");
  visit("beta", o.beta, positive(), "where Smooth L1 turns from square to line");
  visit("centre_of_mass_weight", o.centre_of_mass_weight, anything(),
        "Smooth L1 of the estimated centre of mass, in bounding radii");
  visit("hidden_side_weight", o.hidden_side_weight, anything(),
        "Smooth L1 of the completed hull's extent, in bounding radii");
}

/// App. C.1. A member's name is its YAML key under `optimizer:`.
struct OptimizerOptions {
  double learning_rate = 1e-4;
  double final_learning_rate = 1e-6;
  double warmup = 0.033;
  double weight_decay = 0.01;
  double beta1 = 0.9, beta2 = 0.999;
  double clip_norm = 1.0;
  double ema_decay = 0.0;
};

template <typename Visit>
void for_each_member(OptimizerOptions& o, const Visit& visit) {
  visit("learning_rate", o.learning_rate, positive(), "the highest");
  visit("final_learning_rate", o.final_learning_rate, at_least(0.0), "end of the cosine");
  visit("warmup", o.warmup, share(), "share of all iterations, linear from 10 % of the rate");
  visit("weight_decay", o.weight_decay, anything(), "of AdamW");
  visit("beta1", o.beta1, less_than_all(), "of AdamW");
  visit("beta2", o.beta2, less_than_all(), "of AdamW");
  visit("clip_norm", o.clip_norm, positive(), "longer gradients are shortened to this");
  visit("ema_decay", o.ema_decay, less_than_all(), "weight averaging; 0 = off");
}

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
  int batch_size = 18;
  int micro_batches = 1;
  std::uint64_t seed = 0;
  std::string precision = "float32";
  int log_every = 50;
  double checkpoint_every_s = 180.0;
  double validate_every_s = 300.0;
  int validation_scenes = 30;
};

template <typename Visit>
void for_each_member(TrainingOptions& o, const Visit& visit) {
  visit("model", o.model, anything(), "the network: a preset and its switches");
  visit("windows", o.windows, anything(), "which moments are learned from");
  visit("augmentation", o.augmentation, anything(), "how scenes are observed and varied");
  visit("point_sets", o.point_sets, anything(), "how shapes become point sets");
  visit("loss", o.loss, anything(), "what is penalised");
  visit("optimizer", o.optimizer, anything(), "how weights change");
  visit("unroll", o.unroll, anything(), "how many steps are predicted one after the other, by share of the run");
  visit("iterations", o.iterations, positive(), "of the whole run");
  visit("batch_size", o.batch_size, positive(), "windows per micro-batch");
  visit("micro_batches", o.micro_batches, positive(),
        "per iteration, over all processes: their gradients are averaged");
  visit("seed", o.seed, anything(), "of all randomness");
  visit("precision", o.precision, one_of({"float32", "bfloat16"}), "of the activations");
  visit("log_every", o.log_every, positive(), "iterations between log lines");
  visit("checkpoint_every_s", o.checkpoint_every_s, anything(), "seconds between saved states");
  visit("validate_every_s", o.validate_every_s, anything(), "seconds between validations");
  visit("validation_scenes", o.validation_scenes, positive(), "per archive folder, for rollouts");
}

/// Reads a YAML file; keys left out keep their default (the model's preset for `model:`). `extends: FILE` stands for
/// all that FILE says, which the keys beside it replace one by one; the path is relative to the file that names it.
/// `overrides` go before the file, each "key=value" or "section.key=value" with a value in YAML. Throws
/// std::invalid_argument naming file, key and accepted values for unknown keys, wrong types and values out of range,
/// and for files with several stages.
TrainingOptions load_training_options(const std::filesystem::path& file,
                                      const std::vector<std::string>& overrides = {});

/// Reads a file that may have `stages`, a list of mappings: each says what changes from the stage before, and the first
/// what changes from the rest of the file. `overrides` count in every stage.
std::vector<TrainingOptions> load_training_stages(const std::filesystem::path& file,
                                                  const std::vector<std::string>& overrides = {});

}  // namespace rigidformer
