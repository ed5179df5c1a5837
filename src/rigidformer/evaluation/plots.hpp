// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "rigidformer/evaluation/breakdown.hpp"
#include "rigidformer/evaluation/worst_scenes.hpp"

namespace rigidformer {

/// Errors over the frames (or milliseconds) after the start, for every model.
using ErrorCurves = std::map<std::string, std::map<int, PartialScore>>;

/// Draws the errors of position and orientation from the start to `end`, in `unit`, as SVG; false when gnuplot is not
/// installed.
bool plot_error_curves(const std::filesystem::path& svg, const std::string& title, const ErrorCurves& curves, int end,
                       HorizonUnit unit);

/// Draws recorded (solid) and predicted (dashed) paths from above and from the side as SVG, with a colour per object;
/// false when gnuplot is not installed.
bool plot_paths(const std::filesystem::path& svg, const ScenePaths& scene);

}  // namespace rigidformer
