// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/batch.hpp"

namespace rigidformer {

/// The pose one time step before `now` from which free motion would arrive with the velocity and spin that the last
/// three simulation frames show. Gravity counts where the object was falling during these frames, not where something
/// carried it. The origin of the reference frame must be the centre of mass.
/// `frame_rate_hz` [B] is that of the recordings.
Pose free_motion_departure(const Pose& two_frames_before, const Pose& frame_before, const Pose& now,
                           const SceneBatch& scene, const Tensor& frame_rate_hz);

}  // namespace rigidformer
