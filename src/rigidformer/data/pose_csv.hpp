// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// The measured poses of one object in one recording, in the order of time.
struct MeasuredTrack {
  std::string id;
  std::vector<double> times_s;  ///< Strictly increasing
  std::vector<RigidTransform> T_world_object;
};

/// What was measured at a stretch: a throw, a push, a bag.
struct MeasuredRecording {
  std::string name;
  std::vector<MeasuredTrack> tracks;  ///< By the order in which ids come first
};

/// Reads a table of poses: a line of column names, then a pose per line, columns separated by commas in any order.
/// Needed are `t` or `time` [s], `x`, `y`, `z` [m] and `qx`, `qy`, `qz`, `qw`; other columns are passed over. Without a
/// column `id` all poses are those of an object called `object`. The column `recording_column` tells recordings apart;
/// a file without it is one recording with the name of the file. Throws std::runtime_error naming file, line and what
/// is accepted.
std::vector<MeasuredRecording> read_pose_csv(const std::filesystem::path& path, const std::string& recording_column);

}  // namespace rigidformer
