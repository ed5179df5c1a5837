// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pose_csv.hpp"

namespace rigidformer {

/// Which frames are made of measured poses.
struct FrameOptions {
  double frame_rate_hz = 0.0;   ///< 0 = as measured
  double max_gap_frames = 2.5;  ///< Frames from one measured pose to the next; a longer gap parts the recording
};

/// A stretch of a recording in frames of equal length, with all objects in every frame.
struct MeasuredFrames {
  std::string name;  ///< That of the recording, with `_2`, `_3` ... for what comes after a gap
  double frame_rate_hz = 0.0;
  bool is_resampled = false;
  std::vector<std::string> ids;
  std::vector<std::vector<RigidTransform>> T_world_object;  ///< [object][frame]
};

/// Makes frames of measured poses. Where all objects were measured together in equal steps (to a tenth of one), the
/// measured poses are the frames, untouched: who reads them works at their true rate. Else each frame lies on the
/// straight line (in rotation: slerp) between the two measured poses around it. Nothing is filtered, so that an impact
/// stays within the one interval in which it happened. Only what all objects were seen in counts. Throws
/// std::invalid_argument naming the recording where a higher rate is asked for than was measured (frames would be
/// invented), or where nothing of three frames is left.
std::vector<MeasuredFrames> to_frames(const MeasuredRecording& recording, const FrameOptions& options);

}  // namespace rigidformer
