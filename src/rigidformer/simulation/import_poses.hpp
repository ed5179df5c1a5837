// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "rigidformer/data/measured_motion.hpp"
#include "rigidformer/data/scene_archive.hpp"

namespace rigidformer {

/// What measured poses are made into scenes with. Maps go by the id of the object.
struct ImportOptions {
  std::vector<std::filesystem::path> poses;    ///< Tables of poses, see read_pose_csv()
  std::string recording_column = "recording";  ///< Tells the recordings of one table apart
  std::vector<std::string> recordings;         ///< Those taken, by name or as a range of numbers `0-63`; empty = all
  std::map<std::string, std::string> shapes;   ///< As for measured_shape(); every object needs one
  std::map<std::string, double> masses_kg;     ///< Objects without a value: not known
  std::map<std::string, double> frictions;     ///< Coulomb coefficient, likewise
  std::map<std::string, double> restitutions;  ///< In [0, 1], likewise
  std::set<std::string> static_ids;            ///< Objects that never move
  FrameOptions frames;
  double gravity = -9.81;         ///< [m/s^2] along z
  double length_factor = 1.0;     ///< Measured positions are multiplied by this first, ...
  double ground_height_m = 0.0;   ///< ... then this height is the floor z = 0
  double validation_share = 0.0;  ///< Share of the recordings, the last ones, that is kept apart, in [0, 1)
  std::string set = "measured";   ///< Name of the set
};

/// Scenes by recording: no recording has frames in both.
struct ImportedScenes {
  SceneArchive training, validation;
  std::string summary;  ///< Counts, rates and remarks, one per line
};

/// Throws std::invalid_argument or std::runtime_error naming the file with its line, the recording, the object or the
/// value at fault.
ImportedScenes import_poses(const ImportOptions& options);

}  // namespace rigidformer
