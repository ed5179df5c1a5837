// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/scene/shape.hpp"

namespace rigidformer {

struct MeshVolume {
  double volume_m3 = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< Of the volume
};

/// Of a closed mesh whose triangles face outwards, convex or not.
MeshVolume measure_volume(const ConvexPart& mesh);

/// Of all parts together; where parts overlap, twice.
MeshVolume measure_volume(const std::vector<ConvexPart>& parts);

}  // namespace rigidformer
