// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rigidformer/evaluation/forecaster.hpp"

namespace rigidformer {

/// Names of all physics engines, built in or not.
const std::vector<std::string>& physics_engine_names();

/// Makes the engine of that name. Throws std::runtime_error saying which package is missing when the engine was not
/// there at build time, and std::invalid_argument for an unknown name.
std::unique_ptr<Forecaster> make_physics_engine(const std::string& name);

}  // namespace rigidformer
