// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigidformer/simulation/movi_scene.hpp"

namespace rigidformer {

/// All kinds of scenes by name: movi_sphere, movi_a, movi_b, wrecking_ball_28, _65, _126, _217, walker_15 and
/// walker_31.
const std::vector<std::string>& scene_set_names();

/// Throws std::invalid_argument naming the accepted ones for another name.
void check_scene_set(const std::string& set);

/// Whether the set draws its shapes from a library, which a folder of meshes may replace.
bool draws_from_library(const std::string& set);

/// Whether scenes of the set say what is commanded, which only archives hold.
bool has_commands(const std::string& set);

/// Frames that scenes of the set have where nobody asks for another number.
int usual_num_frames(const std::string& set);

/// Most objects that a scene of the set has.
int max_num_objects(const std::string& set);

/// The shapes of a set; those of MOVi are taken from `library`. Throws std::invalid_argument naming a missing shape.
std::vector<Shape> scene_set_shapes(const std::string& set, const std::vector<Shape>& library);

/// Draws and simulates scene `index` of `seed`. Of `options`, only sets of MOVi read more than which frames are
/// recorded. The same arguments give the same scene.
SceneRecording generate_scene(const std::string& set, const std::vector<Shape>& shapes, std::uint64_t seed,
                              std::uint64_t index, const MoviOptions& options);

}  // namespace rigidformer
