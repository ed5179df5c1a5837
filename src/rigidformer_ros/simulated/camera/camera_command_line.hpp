// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "rigidformer_ros/simulated/camera/camera_options.hpp"

namespace rigidformer_ros::camera {

/// Adds a command-line option of the same name for every camera option.
inline void add_camera_options(CLI::App& app, CameraOptions& options) {
  for_each_member(options, [&app](const std::string& name, auto& value, const Accepts&, const char* description) {
    app.add_option("--" + name, value, description)->capture_default_str();
  });
}

}  // namespace rigidformer_ros::camera
