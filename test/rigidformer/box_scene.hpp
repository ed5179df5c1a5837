// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "rigidformer/scene/object.hpp"

namespace rigidformer {

inline RigidTransform at(double x, double y, double z) { return {Eigen::Quaterniond::Identity(), {x, y, z}}; }

/// The surface of a cube about the origin: 3 x 3 points on each face.
inline Points box_cloud(double edge_m) {
  Points points(54, 3);
  Eigen::Index row = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = -1; side <= 1; side += 2) {
      for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j, ++row) {
          points(row, axis) = static_cast<float>(side);
          points(row, (axis + 1) % 3) = static_cast<float>(i);
          points(row, (axis + 2) % 3) = static_cast<float>(j);
        }
      }
    }
  }
  return 0.5F * static_cast<float>(edge_m) * points;
}

/// A cube of known material that does not move.
inline ObjectState box(const std::string& id, const Eigen::Vector3d& position, double edge_m = 1.0) {
  ObjectState object;
  object.id = id;
  object.points_reference = box_cloud(edge_m);
  object.T_world_current.translation = position;
  object.T_world_previous = object.T_world_current;
  object.properties = {1.0, 0.5, 0.2};
  return object;
}

}  // namespace rigidformer
