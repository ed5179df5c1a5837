// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "rigidformer/data/scene_archive.hpp"

namespace rigidformer {

/// What a window needs: three frames the longest step apart, and every unrolled step.
struct WindowNeeds {
  int longest_step = 1;    ///< [frames of 1/240 s]
  int unrolled_steps = 1;  ///< The most of the run

  /// Frames that a scene of that rate must have.
  int least_frames(double frame_rate_hz) const;
};

/// Removes the scenes of which nothing can be learned: those in which nothing can move, those too short for a
/// window, and those whose frames are longer than any step. Returns sentences that name them, one per line, for the
/// terminal. Throws std::invalid_argument naming set and defect when no scene is left.
std::string leave_out_unusable_scenes(SceneArchive& archive, const WindowNeeds& needs);

}  // namespace rigidformer
