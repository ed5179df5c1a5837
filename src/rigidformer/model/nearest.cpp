// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/nearest.hpp"

#include <algorithm>

namespace rigidformer {
namespace {

constexpr double kFar = 1e6;  // [m^2] rank of points that must not be chosen: above any squared distance
constexpr std::int64_t kMaxMatrixElements = 1 << 28;  // per chunk; 1 GiB of float32; chosen by eye

}  // namespace

Nearest nearest_by_distance_matrix(const SceneBatch& batch, const Pose&, const Tensor& points_world) {
  torch::NoGradGuard no_grad;
  const std::int64_t B = points_world.size(0), K = points_world.size(1), N = points_world.size(2);
  const Tensor x = points_world.detach().to(torch::kFloat32).reshape({B, K * N, 3});
  const Tensor invalid = batch.point_mask.logical_not().reshape({B, K * N, 1}).to(torch::kFloat32);
  const Tensor rank = x.square().sum(-1, true) + kFar * invalid;
  const Tensor query = torch::cat({-2.0 * x, torch::ones_like(rank)}, -1);
  const Tensor key = torch::cat({x, rank}, -1).transpose(1, 2);

  const std::int64_t chunk = std::clamp<std::int64_t>(kMaxMatrixElements / (K * N * K * N), 1, B);
  std::vector<Tensor> indices, values;
  for (std::int64_t begin = 0; begin < B; begin += chunk) {
    const std::int64_t end = std::min(begin + chunk, B);
    const Tensor distance = torch::bmm(query.slice(0, begin, end), key.slice(0, begin, end));
    distance.unflatten(1, {K, N}).unflatten(3, {K, N}).diagonal(0, 1, 3).add_(0.5 * kFar);  // of the same object
    auto [value, index] = distance.min(-1);
    indices.push_back(index);
    values.push_back(value);
  }
  const Tensor found = (torch::cat(values) < 0.25 * kFar).reshape({B, K, N}).logical_and(batch.point_mask);
  return {torch::cat(indices).reshape({B, K, N}), found};
}

}  // namespace rigidformer
