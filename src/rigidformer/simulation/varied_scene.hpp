// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/simulation/movi_scene.hpp"
#include "rigidformer/simulation/mujoco_world.hpp"

namespace rigidformer {

/// A scene with contacts like those of real things: where everything starts, and how each engine is set up for it.
struct VariedScene {
  SceneRecording start;  ///< One frame
  BulletSettings bullet;
  MujocoSettings mujoco;
  double scale = 1.0;  ///< Lengths through those of the MOVi sets
};

/// Draws scene `index` of `seed`: a scene of `set` with 1 ... max_objects objects, as a whole larger or smaller, with
/// spin, other materials, another floor and other solvers. Speeds scale with the square root of lengths, so that
/// everything happens as often. The same arguments give the same scene, whichever engine then moves it.
VariedScene sample_varied_scene(MoviSet set, const std::vector<Shape>& shapes, std::uint64_t seed, std::uint64_t index,
                                MoviOptions options = {});

}  // namespace rigidformer
