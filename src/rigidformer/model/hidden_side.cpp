// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/hidden_side.hpp"

#include "rigidformer/model/centre_of_mass.hpp"

namespace rigidformer {

HiddenSideHeadImpl::HiddenSideHeadImpl() {
  layer1 = register_module("layer1", Linear(3, 64));
  layer2 = register_module("layer2", Linear(64, 128));
  layer3 = register_module("layer3", Linear(128, 256));
  cloud_code = register_module("cloud_code", Linear(512, 128));
  point_code = register_module("point_code", Linear(3, 128));
  offset = register_module("offset", Mlp(128, 128, 3, /*zero_last=*/true));
}

Tensor HiddenSideHeadImpl::forward(const Tensor& points, const Tensor& point_mask, const Tensor& centre) {
  const Tensor radius = bounding_radius(points, point_mask, centre).clamp_min(1e-6).unsqueeze(-1).unsqueeze(-1);
  const Tensor local = (points - centre.unsqueeze(2)) / radius;
  const Tensor f = torch::silu(layer3(torch::silu(layer2(torch::silu(layer1(local))))));       // [B, K, N, 256]
  const Tensor largest = f.masked_fill(point_mask.logical_not().unsqueeze(-1), -1.0).amax(2);  // silu > -1
  const Tensor cloud = cloud_code(torch::cat({largest, centroid(f, point_mask)}, -1)).unsqueeze(2);
  return centre.unsqueeze(2) + radius * (offset(torch::silu(point_code(local) + cloud)) - local);
}

}  // namespace rigidformer
