// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "rigidformer/data/scene_archive.hpp"

namespace rigidformer {

/// Loads scenes with the shapes they use. `path` is one of: an archive (*.safetensors); a folder of archive shards; a
/// Kubric scene folder (metadata.json), a folder of such folders, or one level more. Kubric scenes need their meshes:
/// `shapes`, or, when that is empty, a `shapes` folder beside the scenes. Archives carry their own. At most
/// `max_scenes` scenes are loaded, 0 = all. Throws std::runtime_error naming path and defect.
SceneArchive load_scenes(const std::filesystem::path& path, const std::vector<Shape>& shapes, int max_scenes = 0);

/// Loads scenes as the other load_scenes() does, with meshes read from a folder in KuBasic layout;
/// an empty path stands for none.
SceneArchive load_scenes(const std::filesystem::path& path, const std::filesystem::path& shapes_dir,
                         int max_scenes = 0);

}  // namespace rigidformer
