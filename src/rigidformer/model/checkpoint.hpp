// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "rigidformer/io/tensor_file.hpp"
#include "rigidformer/model/doubt_table.hpp"
#include "rigidformer/model/rigidformer.hpp"

namespace rigidformer {

/// The origin of a model and what it has seen; stored beside the weights.
struct TrainingFacts {
  std::string data;  ///< Names of the sets and number of scenes
  std::int64_t iterations = 0;
  std::int64_t windows = 0;  ///< Windows learned from
  std::uint64_t seed = 0;
  std::string source_revision;           ///< Revision of the code that trained it
  double min_step_frames = 1.0;          ///< Smallest trained step size s, in frames of 1/240 s
  double max_step_frames = 10.0;         ///< Largest trained step size s
  double min_diameter_m = 0.0;           ///< Diameter of the smallest object seen
  double max_diameter_m = 0.0;           ///< Diameter of the largest object seen
  double max_speed_mps = 0.0;            ///< Highest speed of a centre of mass seen
  int min_points = 0;                    ///< Fewest points per object seen
  int max_points = 0;                    ///< Most points per object seen
  std::optional<DoubtTable> doubt = {};  ///< How far its forecasts are from the truth; empty = not measured
};

/// A model as loaded from disk.
struct Checkpoint {
  RigidFormer model{nullptr};
  TrainingFacts facts;
  std::string sha256;
};

/// Writes weights (stored as float32 or bfloat16), options and facts into one tensor file.
void save_checkpoint(const std::filesystem::path& path, const RigidFormer& model, const TrainingFacts& facts,
                     TensorType storage = TensorType::kFloat32);

/// Loads a model on the CPU in float32. Throws std::runtime_error naming path and defect: not a tensor file, wrong
/// hash, not a checkpoint, unsupported version, bad options, missing, surplus, misshaped or non-finite tensors.
Checkpoint load_checkpoint(const std::filesystem::path& path);

}  // namespace rigidformer
