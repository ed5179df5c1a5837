// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "rigidformer/engine/observed_solid.hpp"
#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// How far apart two bodies are, or a body and the ground. Bodies are numbered in the order of the scene.
struct SolidGap {
  int body = 0;
  int partner = -1;        ///< -1 = the ground
  Eigen::Vector3d normal;  ///< Unit, from the partner to the body
  double gap_m = 0.0;      ///< Negative = they overlap
};

/// The convex hulls of a scene above a level ground. Geometry only; may be used from several threads.
class SolidScene {
 public:
  SolidScene(std::vector<ObservedSolid> solids, double ground_height_m);

  const std::vector<ObservedSolid>& solids() const { return solids_; }

  /// Poses of the bodies, each with its origin in the centre of mass, from those of the reference frames.
  std::vector<RigidTransform> body_poses(const std::vector<RigidTransform>& T_world_reference) const;

  /// All gaps below `reach_m`, the ground's first. Poses have their origin in the centre of mass.
  std::vector<SolidGap> gaps(const std::vector<RigidTransform>& T_world_body, double reach_m) const;

  /// Which dynamic bodies lie or roll on something that does not let them fall: on the ground, on a body whose motion
  /// is given, or on one that is carried itself. `rising_mps` are the vertical velocities of all bodies.
  std::vector<bool> carried(const std::vector<RigidTransform>& T_world_body,
                            const std::vector<double>& rising_mps) const;

 private:
  void add_gap(std::size_t body, std::size_t partner, const std::vector<RigidTransform>& T_world_body, double reach_m,
               std::vector<SolidGap>& gaps) const;
  double height(std::size_t body, const RigidTransform& T_world_body) const;

  std::vector<ObservedSolid> solids_;
  double ground_height_m_;
};

}  // namespace rigidformer
