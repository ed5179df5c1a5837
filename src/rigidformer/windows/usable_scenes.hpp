// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "rigidformer/data/scene_archive.hpp"

namespace rigidformer {

/// Removes the scenes of which nothing can be learned: those in which nothing can move, and those of fewer than
/// `least_frames` frames. Returns sentences that name them, one per line, for the terminal. Throws
/// std::invalid_argument naming set and defect when no scene is left.
std::string leave_out_unusable_scenes(SceneArchive& archive, int least_frames);

}  // namespace rigidformer
