// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/free_motion.hpp"

namespace rigidformer {
namespace {

/// Rotation vectors [..., 3] of rotations [..., 3, 3] by less than a quarter turn.
Tensor rotation_vector(const Tensor& R) {
  const Tensor twice = R - R.transpose(-1, -2);
  const Tensor sine_axis = 0.5 * torch::stack({twice.select(-2, 2).select(-1, 1), twice.select(-2, 0).select(-1, 2),
                                               twice.select(-2, 1).select(-1, 0)},
                                              -1);
  const Tensor sine = sine_axis.norm(2, -1, true).clamp(1e-12, 1.0);
  return sine_axis / sine * sine.asin();
}

/// Rotations [..., 3, 3] of rotation vectors [..., 3].
Tensor rotation_of(const Tensor& vector) {
  const auto w = vector.unbind(-1);
  const Tensor zero = torch::zeros_like(w[0]);
  return torch::stack({zero, -w[2], w[1], w[2], zero, -w[0], -w[1], w[0], zero}, -1).unflatten(-1, {3, 3}).matrix_exp();
}

}  // namespace

Pose free_motion_departure(const Pose& two_frames_before, const Pose& frame_before, const Pose& now,
                           const SceneBatch& scene, const Tensor& frame_rate_hz) {
  const Tensor rate = frame_rate_hz.to(now.translation.options()).reshape({-1, 1, 1});
  const Tensor s = scene.step_size.reshape({-1, 1, 1}) * rate / kFrameRateHz;  // frames of the recording per step
  const Tensor step = now.translation - frame_before.translation;
  const Tensor bend = step - (frame_before.translation - two_frames_before.translation);
  // Change of the step per frame in free flight.
  const Tensor fall = scene.gravity.reshape({-1, 1, 1}) / rate.square();
  const Tensor falls = (bend.slice(-1, 2) - fall).abs() < (bend.slice(-1, 2)).abs();
  const Tensor back = torch::cat({torch::zeros_like(step.slice(-1, 0, 2)), fall * falls}, -1) * (s * (s - 1.0) / 2.0);
  const Tensor turn = rotation_vector(torch::matmul(now.rotation, frame_before.rotation.transpose(-1, -2)));
  return {torch::matmul(rotation_of(-s * turn), now.rotation), now.translation - s * step + back};
}

}  // namespace rigidformer
