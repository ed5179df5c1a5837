// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/anchors.hpp"

#include <vector>

#include "rigidformer/model/centre_of_mass.hpp"

namespace rigidformer {

Tensor farthest_anchors(const Tensor& points, const Tensor& point_mask, int num_anchors, const Tensor& start_score) {
  torch::NoGradGuard no_grad;
  const Tensor invalid = point_mask.logical_not();
  const Tensor to_centroid = (points - centroid(points, point_mask).unsqueeze(2)).square().sum(-1);
  const Tensor first_score = start_score.defined() ? start_score : to_centroid;
  std::vector<Tensor> chosen = {first_score.masked_fill(invalid, -1.0).argmax(-1)};
  Tensor distance = torch::full_like(to_centroid, 1e9).masked_fill(invalid, -1.0);
  while (static_cast<int>(chosen.size()) < num_anchors) {
    const Tensor newest = gather_points(points, chosen.back().unsqueeze(-1));  // [B, K, 1, 3]
    distance = torch::minimum(distance, (points - newest).square().sum(-1)).masked_fill(invalid, -1.0);
    chosen.push_back(distance.argmax(-1));
  }
  return torch::stack(chosen, -1);
}

}  // namespace rigidformer
