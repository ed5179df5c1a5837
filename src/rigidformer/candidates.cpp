// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/candidates.hpp"

namespace rigidformer {

bool BoxRegion::contains(const Eigen::Vector3d& point_world) const {
  const Eigen::Vector3d point_box = T_world_box.inverse() * point_world;
  return (point_box.cwiseAbs().array() <= 0.5 * size_m.array()).all();
}

}  // namespace rigidformer
