// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "rigidformer/data/scene_archive.hpp"
#include "scratch_file.hpp"
#include "sealed_file.hpp"

/// Checks that every accepted archive has valid poses for all frames, of shapes that it holds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFolder folder;
  const std::string file = sealed_file(std::string(reinterpret_cast<const char*>(data), size));
  const auto path = folder.write("file", reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
  try {
    const rigidformer::SceneArchive archive = rigidformer::read_scene_archive(path);
    for (const rigidformer::SceneRecording& scene : archive.scenes) {
      for (const rigidformer::RecordedObject& object : scene.objects) {
        if (object.T_world_object.size() != static_cast<std::size_t>(scene.num_frames)) __builtin_trap();
        for (const rigidformer::RigidTransform& pose : object.T_world_object) {
          if (!rigidformer::is_valid(pose)) __builtin_trap();
        }
      }
    }
  } catch (const std::runtime_error&) {
  }
  return 0;
}
