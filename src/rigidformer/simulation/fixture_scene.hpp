// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/simulation/varied_scene.hpp"

namespace rigidformer {

/// A scene with static fixtures and driven bodies.
struct FixtureScene {
  VariedScene scene;
  std::vector<MotionPath> paths;  ///< One per object; empty but for driven ones. Time 0 is the first recorded frame
};

/// Adds up to two fixtures and two drivers to a scene of free objects that have not moved yet. These get other places:
/// some rest where a driver goes for them, the others are thrown at what there is; those that find no room are left
/// out. All of it follows from seed, index and `attempt`, and is the same for every engine. `shapes` holds those of the
/// objects and fixture_shapes(). Throws std::runtime_error where nothing finds room.
FixtureScene add_fixtures(const VariedScene& scene, const std::vector<Shape>& shapes, std::uint64_t seed,
                          std::uint64_t index, std::uint64_t attempt, double duration_s);

/// Whether no free object of a recording was ever thrown by an overlap: fast as nothing that fell or was pushed is.
bool is_calm(const SceneRecording& recording, double unit_m);

}  // namespace rigidformer
