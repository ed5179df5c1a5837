// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/command.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace rigidformer {

void check_commands(const RolloutOptions& rollout, int control_dim) {
  const auto& control = rollout.control;
  if (control_dim > 0 && control.empty()) {
    throw std::invalid_argument("control is empty, the model wants a command of " + std::to_string(control_dim) +
                                " numbers");
  }
  if (control.size() > 1 && control.size() < static_cast<size_t>(rollout.num_steps)) {
    throw std::invalid_argument("control has " + std::to_string(control.size()) +
                                " commands, must be one or one for each of the " + std::to_string(rollout.num_steps) +
                                " steps");
  }
  for (const std::vector<double>& command : control) {
    if (command.size() != static_cast<size_t>(control_dim)) {
      throw std::invalid_argument("control has a command of " + std::to_string(command.size()) +
                                  " numbers, the model wants " + std::to_string(control_dim));
    }
    if (!std::all_of(command.begin(), command.end(), [](double value) { return std::isfinite(value); })) {
      throw std::invalid_argument("control must be finite");
    }
  }
}

Tensor command_of_step(const RolloutOptions& rollout, std::int64_t step) {
  if (rollout.control.empty()) return {};
  const auto last = static_cast<std::int64_t>(rollout.control.size()) - 1;
  const std::vector<double>& command = rollout.control[static_cast<size_t>(std::min(step, last))];
  return torch::tensor(command, torch::kFloat32).unsqueeze(0);
}

}  // namespace rigidformer
