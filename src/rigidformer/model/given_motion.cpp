// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/given_motion.hpp"

namespace rigidformer {
namespace {

/// Makes one Newton step towards the nearest rotation. Without it rounding errors of products of rotations would grow
/// exponentially: each step multiplies them by 1 + sqrt(2).
Tensor orthonormalized(const Tensor& R) {
  return 1.5 * R - 0.5 * torch::matmul(R, torch::matmul(R.transpose(-1, -2), R));
}

}  // namespace

Pose coming_pose(const SceneState& state) {
  if (state.coming.rotation.defined()) return state.coming;
  const Tensor spin = torch::matmul(state.current.rotation, state.previous.rotation.transpose(-1, -2));
  const Tensor step = (state.current.translation - state.previous.translation).unsqueeze(-1);
  return {orthonormalized(torch::matmul(spin, state.current.rotation)),
          state.current.translation + torch::matmul(spin, step).squeeze(-1)};
}

}  // namespace rigidformer
