// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigidformer/scene/recording.hpp"
#include "rigidformer/scene/shape.hpp"
#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {

/// The three MOVi variants: spheres only; cubes, cylinders and spheres; everyday and organic shapes.
enum class MoviSet { kSphere, kA, kB };

/// Reads movi_sphere, movi_a or movi_b. Throws std::invalid_argument for another name.
MoviSet parse_movi_set(const std::string& name);
std::string to_string(MoviSet set);

/// How scenes of all sets are drawn, with the constants of the published sets.
struct MoviOptions {
  int num_frames = 480;  ///< Frames that are recorded
  int first_frame = 0;   ///< Frames simulated before the recording begins: after a few seconds most objects rest
  int min_objects = 3;
  int max_objects = 10;
  double small_size = 0.7;  ///< Uniform scale of small objects; set B draws between small and large
  double large_size = 1.4;
  Eigen::Vector3d region_min{-5.0, -5.0, 1.0};  ///< Objects start inside this box [m]
  Eigen::Vector3d region_max{5.0, 5.0, 5.0};    ///< Upper corner of the box [m]
  double max_speed_mps = 4.0;  ///< Largest horizontal velocity per axis, before the pull to the middle is added
  int placement_tries = 100;   ///< Places tried per object before the scene is drawn again
};

/// Picks the shapes of `set` from `library`: the named ones for Sphere and A; for B the 11 of MOVi-B when all are
/// there, else the whole library. Throws std::invalid_argument naming a missing shape.
std::vector<Shape> movi_shapes(MoviSet set, const std::vector<Shape>& library);

/// The names of these shapes when those in `available` can be had.
std::vector<std::string> movi_shape_names(MoviSet set, const std::vector<std::string>& available);

/// Bullet settings of `set`; the sets differ in the solver's rate.
BulletSettings movi_bullet_settings(MoviSet set);

/// Draws the initial state (one frame) of scene `index` of `seed`. The same arguments give the same scene.
SceneRecording sample_movi_scene(MoviSet set, const std::vector<Shape>& shapes, std::uint64_t seed, std::uint64_t index,
                                 const MoviOptions& options = {});

/// Draws and simulates scene `index` of `seed`.
SceneRecording generate_movi_scene(MoviSet set, const std::vector<Shape>& shapes, std::uint64_t seed,
                                   std::uint64_t index, const MoviOptions& options = {});

}  // namespace rigidformer
