// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "rigidformer/data/kubric.hpp"
#include "scratch_file.hpp"

/// Reads the bytes as a scene and checks that every accepted one has a valid pose per object and frame, positive sizes,
/// and gravity downwards.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFolder folder;
  const std::filesystem::path path = folder.write("metadata.json", data, size);
  try {
    const rigidformer::SceneRecording scene = rigidformer::read_kubric_scene(path);
    if (!rigidformer::points_down(scene.gravity)) __builtin_trap();
    for (const rigidformer::RecordedObject& object : scene.objects) {
      if (!(object.size > 0.0 && object.largest_extent_m.value_or(1.0) > 0.0)) __builtin_trap();
      if (object.T_world_object.size() != static_cast<std::size_t>(scene.num_frames)) __builtin_trap();
      for (const rigidformer::RigidTransform& pose : object.T_world_object) {
        if (!rigidformer::is_valid(pose)) __builtin_trap();
      }
    }
  } catch (const std::runtime_error&) {
  }
  return 0;
}
