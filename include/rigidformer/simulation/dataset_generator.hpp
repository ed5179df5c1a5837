// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <string>

#include "rigidformer/simulation/movi_scene.hpp"

namespace rigidformer {

/// The data set to generate and its place.
struct DatasetOptions {
  std::string set = "movi_a";      ///< One of scene_set_names()
  int num_scenes = 0;              ///< Number of scenes, at least 1
  std::uint64_t seed = 0;          ///< Scene i depends on the seed and on i only
  std::filesystem::path output;    ///< Folder, made when missing
  std::filesystem::path shapes;    ///< Folder in KuBasic layout; empty = built-in shapes
  std::string engine = "bullet";   ///< bullet | mujoco, which must be built in
  std::string contacts = "movi";   ///< movi | varied: materials, floors, sizes and solvers of wide ranges
  bool fixtures = false;           ///< Adds tables, shelves, walls, ..., and bodies that are driven
  std::string format = "archive";  ///< archive (shards of 100 scenes) | kubric (one folder per scene)
  MoviOptions movi;                ///< Which frames are recorded and how scenes are drawn
  int jobs = 1;                    ///< Number of threads

  /// Throws std::invalid_argument naming field and value, and std::runtime_error for an engine that is not built in.
  void validate() const;
};

/// Generates a data set; progress and warnings go to `log`. Finished parts found in the folder are kept, so that an
/// interrupted run can be repeated with the same arguments. Throws std::runtime_error when the folder holds scenes of
/// another set, seed, shape library or format.
void generate_dataset(const DatasetOptions& options, std::ostream& log);

}  // namespace rigidformer
