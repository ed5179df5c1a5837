// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "rigidformer/scene/recording.hpp"
#include "walker_gait.hpp"

namespace rigidformer {

constexpr double kWalkerFrameRate_hz = 30.0;  ///< App. I.1
constexpr int kWalkerFrames = 300;            ///< App. I.1

/// The command of every frame of a scene: it changes every two to four seconds, by up to a quarter turn. It changes at
/// multiples of ten frames, so that steps of ten frames from such a frame on have one command each.
std::vector<WalkerCommand> draw_walker_commands(const WalkerDesign& design, std::uint64_t seed, std::uint64_t index,
                                                int num_frames);

/// Simulates a walker that follows these commands, from `first_frame` frames after it has begun to walk.
SceneRecording simulate_walker(const WalkerDesign& design, const std::vector<WalkerCommand>& commands,
                               std::uint64_t seed, std::uint64_t index, int first_frame = 0);

}  // namespace rigidformer
