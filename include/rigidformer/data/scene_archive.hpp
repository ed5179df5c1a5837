// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigidformer/scene/recording.hpp"
#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Many recordings of one set with the shapes that they use: everything that training and evaluation need, in
/// one file. It is stored as a tensor file (see io/tensor_file.hpp); docs/data_format.md lists the tensors and
/// shows how to read them in Python.
struct SceneArchive {
  std::string set;  ///< movi_sphere | movi_a | movi_b | free name
  std::vector<Shape> shapes;
  std::vector<SceneRecording> scenes;  ///< Poses are stored in float32; velocities are not stored
};

/// Throws std::runtime_error naming path and defect.
void write_scene_archive(const std::filesystem::path& path, const SceneArchive& archive);

/// Throws std::runtime_error naming path and defect.
SceneArchive read_scene_archive(const std::filesystem::path& path);

}  // namespace rigidformer
