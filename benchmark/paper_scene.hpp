// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/model/batch.hpp"
#include "rigidformer/scene/object.hpp"

namespace rigidformer {

/// A scene of the sizes of the paper's App. F.1: 10 objects with 64, 51, 1142, 64, 64, 682, 682, 647, 51 and 569 points
/// (4,016), as spheres, spread over a MOVi arena, moving and spinning. It is the same at every call.
std::vector<ObjectState> paper_scene();

/// The scene's poses after `step` small motions.
std::vector<RigidTransform> moved_poses(const std::vector<ObjectState>& objects, int step);

/// The scene as padded tensors, B = 1, with points in farthest-point order, 4 anchors and a step size of 10 frames.
SceneBatch as_batch(const std::vector<ObjectState>& objects);
SceneState as_state(const std::vector<ObjectState>& objects);

}  // namespace rigidformer
