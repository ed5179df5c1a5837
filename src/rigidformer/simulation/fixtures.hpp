// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "fixture_shapes.hpp"
#include "random_draws.hpp"

namespace rigidformer {

/// A block of a fixture: its centre in the fixture's frame, whose z = 0 is the floor.
struct PlacedBlock {
  Block block;
  RigidTransform T_fixture_block;
};

/// What thrown objects aim at, in the fixture's frame.
struct Aim {
  Eigen::Vector3d point;
  std::optional<Eigen::Vector3d> heading = {};  ///< Level direction of flight; empty = any
};

/// A level surface on which objects can lie and drivers work, in the fixture's frame.
struct Top {
  Eigen::Vector3d middle;
  Eigen::Vector2d half_edges;
};

/// Something that stands on the floor and never moves.
struct Fixture {
  std::vector<PlacedBlock> blocks;
  std::vector<Aim> aims;
  std::optional<Top> top;
  double radius_m = 0.0;  ///< Of the floor that it takes
};

/// Draws a table, a shelf of boards, a bin of five slabs, a wall, a ramp or a group of pegs. `unit_m` is the length
/// that objects of about 1 m have in the scene.
Fixture draw_fixture(double unit_m, Random& random);

}  // namespace rigidformer
