// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/PredictRollout.h>

#include <vector>

#include "rigidformer/predictor.hpp"

namespace rigidformer_ros {

/// The command of every step of a request, or one for all; empty for models without commands. Throws RequestError.
std::vector<std::vector<double>> read_control(const PredictRollout::Request& request, int num_steps,
                                              const rigidformer::ModelInfo& model);

}  // namespace rigidformer_ros
