// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

/// Volume that a mesh encloses, with its centre.
struct MeshVolume {
  double volume_m3 = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< Centroid of the volume
};

/// Measures a closed mesh whose triangles face outwards; it need not be convex.
MeshVolume measure_volume(const ConvexPart& mesh);

/// Measures all parts together; volume where parts overlap counts twice.
MeshVolume measure_volume(const std::vector<ConvexPart>& parts);

/// Inertia tensor of a solid of mass 1 kg and uniform density about the origin, which must lie inside the closed mesh
/// [m^2].
Eigen::Matrix3d inertia_per_mass(const ConvexPart& mesh);

}  // namespace rigidformer
