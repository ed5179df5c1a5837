// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rigidformer/scene/recording.hpp"
#include "rigidformer/scene/shape.hpp"
#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {

/// Scenes of App. H: a ball flies into a wall of edge^3 cubes. The paper says the number of cubes, their mass, friction
/// and restitution, the perturbed grid and the random velocity; everything else was chosen here.
struct WreckingBallOptions {
  int cubes_per_edge = 3;      ///< 3 ... 6 in the paper
  double cube_edge_m = 1.0;    ///< As large as the objects of the MOVi scenes; chosen here
  double spacing_m = 1.06;     ///< Between the middles of neighbouring columns; chosen here
  double max_shift_m = 0.015;  ///< Every cube is moved by up to this along x and y ...
  double max_yaw_rad = 0.02;   ///< ... and turned about the vertical by up to this; both chosen here
  double layer_gap_m = 0.004;  ///< Between layers at the start: twice what Bullet keeps hulls apart
  double ball_size = 1.5;      ///< Diameter [m]; chosen here
  double ball_mass_kg = 10.0;  ///< The paper says the cubes' mass only; chosen here
  double min_speed_mps = 8.0;  ///< Of the ball; chosen here
  double max_speed_mps = 14.0;
  double min_gap_m = 0.4;  ///< Between ball and wall at the start: it arrives within 30 frames; chosen here
  double max_gap_m = 1.0;
};

/// Reads wrecking_ball_28, _65, _126 or _217 (numbers of objects); empty for other names.
std::optional<WreckingBallOptions> wrecking_ball_set(const std::string& name);
const std::vector<std::string>& wrecking_ball_set_names();

/// A cube of 8 corners and a ball, both of size 1.
const std::vector<Shape>& wrecking_ball_shapes();

/// The floor has the cubes' friction and restitution. Every frame is one step of the solver, as in the paper.
BulletSettings wrecking_ball_settings();

/// Draws the initial state (one frame) of scene `index` of `seed`: first the cubes, layer by layer, then the ball. The
/// same arguments give the same scene.
SceneRecording sample_wrecking_ball_scene(const WreckingBallOptions& options, std::uint64_t seed, std::uint64_t index);

}  // namespace rigidformer
