// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/rollout_command.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "rigidformer_ros/services/request_error.hpp"

namespace rigidformer_ros {

std::vector<std::vector<double>> read_control(const PredictRollout::Request& request, int num_steps,
                                              const rigidformer::ModelInfo& model) {
  const auto dim = static_cast<std::size_t>(model.control_dim), given = request.control.size();
  if (given != dim && (dim == 0 || given != dim * static_cast<std::size_t>(num_steps))) {
    throw RequestError(PredictRollout::Response::INVALID_REQUEST,
                       "control: has " + std::to_string(given) + " numbers, the model takes " + std::to_string(dim) +
                           ", for all steps or for each of them");
  }
  if (!std::all_of(request.control.begin(), request.control.end(), [](double value) { return std::isfinite(value); })) {
    throw RequestError(PredictRollout::Response::INVALID_REQUEST, "control: must be finite");
  }
  std::vector<std::vector<double>> commands;
  for (std::size_t i = 0; i < given; i += dim) {
    commands.emplace_back(&request.control[i], &request.control[i] + dim);
  }
  return commands;
}

}  // namespace rigidformer_ros
