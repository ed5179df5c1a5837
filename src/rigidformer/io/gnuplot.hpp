// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace rigidformer {

/// Quotes a path as a string of gnuplot.
std::string gnuplot_string(const std::filesystem::path& path);

/// Runs commands in gnuplot; false when it is not installed or fails.
bool run_gnuplot(const std::string& commands);

}  // namespace rigidformer
