// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/scene/recording.hpp"

namespace rigidformer {

bool points_down(const Eigen::Vector3d& gravity) {
  constexpr double kSteepest = 0.035;  // tangent of two degrees: builders' floors are flatter; chosen by eye
  return gravity.allFinite() && gravity.z() <= 0.0 && gravity.head<2>().norm() <= kSteepest * -gravity.z();
}

}  // namespace rigidformer
