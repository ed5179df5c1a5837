// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/scene/recording.hpp"

#include <algorithm>

namespace rigidformer {

bool points_down(const Eigen::Vector3d& gravity) {
  constexpr double kSteepest = 0.035;  // tangent of two degrees: builders' floors are flatter; chosen by eye
  return gravity.allFinite() && gravity.z() <= 0.0 && gravity.head<2>().norm() <= kSteepest * -gravity.z();
}

std::vector<std::vector<double>> commands_of_steps(const SceneRecording& scene, int frame, int step, int num_steps) {
  std::vector<std::vector<double>> commands;
  if (scene.control.empty()) return commands;
  for (int k = 0; k < num_steps; ++k) {
    const auto at = static_cast<std::size_t>(frame + k * step);
    commands.push_back(scene.control[std::min(at, scene.control.size() - 1)]);
  }
  return commands;
}

}  // namespace rigidformer
