// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/scene/recording.hpp"

namespace rigidformer {

bool points_down(const Eigen::Vector3d& gravity) {
  constexpr double kLevel = 1e-4;  // of its size: what rounding leaves in a file
  return gravity.allFinite() && gravity.z() <= 0.0 && gravity.head<2>().norm() <= kLevel * -gravity.z();
}

}  // namespace rigidformer
