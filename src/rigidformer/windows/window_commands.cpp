// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/window_commands.hpp"

namespace rigidformer {

std::vector<Tensor> window_commands(const SceneTensors& tensors, const Tensor& frame, const Tensor& yaw) {
  if (!tensors.control.defined()) return {};
  const std::int64_t first_direction = tensors.control.size(2) - 2 * tensors.control_directions;
  const Tensor turn = yaw.slice(-2, 0, 2).slice(-1, 0, 2);  // [B, 2, 2] in the plane
  std::vector<Tensor> commands;
  for (std::int64_t t = 1; t + 1 < frame.size(1); ++t) {
    const Tensor command = tensors.control.flatten(0, 1).index({frame.select(1, t)});
    const Tensor directions = command.slice(-1, first_direction).unflatten(-1, {tensors.control_directions, 2});
    const Tensor turned = torch::matmul(directions, turn.transpose(-1, -2)).flatten(-2);
    commands.push_back(torch::cat({command.slice(-1, 0, first_direction), turned}, -1));
  }
  return commands;
}

}  // namespace rigidformer
