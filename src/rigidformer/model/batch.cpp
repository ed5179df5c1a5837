// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/batch.hpp"

namespace rigidformer {
namespace {

Tensor moved(const Tensor& tensor, const torch::Device& device) {
  return tensor.defined() ? tensor.to(device) : tensor;
}

}  // namespace

Pose Pose::to(const torch::Device& device) const { return {moved(rotation, device), moved(translation, device)}; }

SceneBatch SceneBatch::to(const torch::Device& device) const {
  SceneBatch batch;
  for (const auto tensor : kBatchTensors) batch.*tensor = moved(this->*tensor, device);
  return batch;
}

SceneState SceneState::to(const torch::Device& device) const {
  return {first.to(device), previous.to(device), current.to(device), coming.to(device)};
}

Tensor Pose::apply(const Tensor& points_reference) const {
  return torch::matmul(points_reference, rotation.transpose(-1, -2)) + translation.unsqueeze(-2);
}

Tensor SceneBatch::time_step() const { return step_size / kFrameRateHz; }

Tensor SceneBatch::anchors_reference() const { return gather_points(points_reference, anchor_index); }

Tensor SceneBatch::ground_code() const {
  if (!ground_material.defined()) return torch::zeros({num_scenes(), kGroundCode}, step_size.options());
  return torch::cat({ground_material * ground_known, ground_known}, -1);
}

Tensor gather_points(const Tensor& values, const Tensor& index) {
  const auto wide = index.unsqueeze(-1).expand({index.size(0), index.size(1), index.size(2), values.size(3)});
  return values.gather(2, wide);
}

Tensor gather_scene_points(const Tensor& values, const Tensor& index) {
  const std::int64_t B = values.size(0), K = values.size(1), N = values.size(2), C = values.size(3);
  const auto wide = index.reshape({B, K * N, 1}).expand({B, K * N, C});
  return values.reshape({B, K * N, C}).gather(1, wide).reshape({B, K, N, C});
}

}  // namespace rigidformer
