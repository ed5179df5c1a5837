// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "rigidformer/scene/recording.hpp"

namespace rigidformer {

/// Reads a Kubric `metadata.json` (path of the file or of its folder) by the rules of docs/data_format.md. Quaternions
/// are w x y z in the file. Velocities, mass, friction, restitution and size may be absent; where `scale` stands
/// instead of `size`, `largest_extent_m` is set and load_scenes() makes a size of it. Backgrounds are left out. Throws
/// std::runtime_error naming path, key and value.
SceneRecording read_kubric_scene(const std::filesystem::path& path);

/// Writes `<folder>/metadata.json`. Throws std::runtime_error.
void write_kubric_scene(const std::filesystem::path& folder, const SceneRecording& scene);

}  // namespace rigidformer
