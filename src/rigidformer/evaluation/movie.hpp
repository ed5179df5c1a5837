// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "rigidformer/evaluation/forecaster.hpp"
#include "rigidformer/evaluation/observation.hpp"

namespace rigidformer {

/// The part of a recording that a movie shows, in frames of the recording.
struct MovieOptions {
  int start = 120;       ///< First of the two given frames
  int step = 10;         ///< Frames per predicted step, and per picture
  int num_steps = 24;    ///< Predicted steps
  int picture_time = 8;  ///< Time that a picture stays [1/100 s]
};

/// Draws the recorded and the predicted motion of the observed points side by side as an animated GIF, a colour per
/// object. False when gnuplot is not installed. Throws std::invalid_argument when the recording is too short.
bool draw_movie(const std::filesystem::path& gif, const SceneRecording& scene, const Observer& observer,
                Forecaster& forecaster, const MovieOptions& options);

}  // namespace rigidformer
