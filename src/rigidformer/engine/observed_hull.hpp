// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// A solid that stands for an observed object.
struct ObservedHull {
  ConvexPart hull;                 ///< Relative to the centre of mass [m]
  Eigen::Vector3d centre_of_mass;  ///< In the frame of the points [m]
  double volume_m3 = 0.0;
  bool complete = false;  ///< All sides are seen
};

/// Convex hull of the points [N, 3], at least one. Where its centre lies near the estimated centre of mass, all sides
/// are seen, and it is the better estimate. Else the points are one side of the object only: `hidden` [H, 3], or
/// without any the mirror images of the points through the centre of mass, stand for the other side.
ObservedHull observe_hull(const Points& points, const Eigen::Vector3d& centre_of_mass, const Points& hidden = {});

}  // namespace rigidformer
