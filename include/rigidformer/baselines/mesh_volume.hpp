// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

struct MeshVolume {
  double volume_m3 = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< Of the volume
};

/// Of a closed mesh whose triangles face outwards, convex or not.
MeshVolume measure_volume(const ConvexPart& mesh);

}  // namespace rigidformer
