// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// A rigid part of a walker. Its own x axis runs along it.
struct WalkerPart {
  std::string shape;
  Eigen::Vector3d half_extents_m;
  double mass_kg = 0.0;
  RigidTransform T_torso_part;  ///< With all joint angles zero
};

/// A joint that turns the child against the parent about an axis. Point and axis are in the torso's frame with all
/// joint angles zero.
struct WalkerHinge {
  int parent = 0, child = 0;
  Eigen::Vector3d point, axis;
};

/// A leg and its joints, all indices into the hinges.
struct WalkerLeg {
  Eigen::Vector3d hip;         ///< Torso frame [m]
  double outward_rad = 0.0;    ///< Where the leg points, from the torso's x axis about z
  double phase = 0.0;          ///< Ahead of the gait's cycle, in cycles
  double reach_m = 0.0;        ///< Horizontal distance from hip to foot
  int swing = -1, lift = -1;   ///< About the vertical; up and down
  std::optional<int> upright;  ///< Keeps the shin upright while the leg is lifted
};

/// Crawlers for App. I, whose humanoids come from learned policies that are out of reach: many short legs on hinges
/// with position motors, which need no balance. All sizes were chosen here.
struct WalkerDesign {
  std::vector<WalkerPart> parts;  ///< The torso first
  std::vector<WalkerHinge> hinges;
  std::vector<WalkerLeg> legs;
  std::optional<int> neck;  ///< Hinge that turns the head to where it is told to look
  double height_m = 0.0;    ///< Of the torso's middle above the feet
  int points_per_part = 0;  ///< App. I.1: up to 300, and 200
};

/// Reads walker_15 (torso, six legs of two parts, neck, head) or walker_31 (torso, ten legs of three parts); null for
/// other names.
const WalkerDesign* walker_set(const std::string& name);
const std::vector<std::string>& walker_set_names();

/// The shapes of the parts, rounded boxes with that many corners.
std::vector<Shape> walker_shapes(const WalkerDesign& design);

}  // namespace rigidformer
