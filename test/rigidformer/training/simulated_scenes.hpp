// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/data/scene_archive.hpp"
#ifdef RIGIDFORMER_HAS_SIMULATION
#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/movi_scene.hpp"

namespace rigidformer {

/// A few scenes to learn from, which are the same every time.
inline const SceneArchive& simulated_scenes() {
  static const SceneArchive scenes = [] {
    SceneArchive archive;
    archive.set = "movi_a";
    archive.shapes = movi_shapes(MoviSet::kA, builtin_shapes());
    for (std::uint64_t i = 0; i < 3; ++i) {
      archive.scenes.push_back(generate_movi_scene(MoviSet::kA, archive.shapes, 17, i, {}));
    }
    return archive;
  }();
  return scenes;
}

}  // namespace rigidformer
#endif
