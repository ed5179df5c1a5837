// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/centre_of_mass.hpp"

namespace rigidformer {

Tensor centroid(const Tensor& points, const Tensor& point_mask) {
  const Tensor weight = point_mask.unsqueeze(-1).to(points.scalar_type());
  return (points * weight).sum(2) / weight.sum(2).clamp_min(1.0);
}

Tensor bounding_radius(const Tensor& points, const Tensor& point_mask, const Tensor& centre) {
  const Tensor distance = (points - centre.unsqueeze(2)).square().sum(-1);
  return distance.masked_fill(point_mask.logical_not(), 0.0).amax(2).clamp_min(1e-12).sqrt();
}

CentreOfMassHeadImpl::CentreOfMassHeadImpl() {
  layer1 = register_module("layer1", Linear(3, 64));
  layer2 = register_module("layer2", Linear(64, 128));
  layer3 = register_module("layer3", Linear(128, 256));
  output = register_module("output", Mlp(512, 128, 3, /*zero_last=*/true));
}

Tensor CentreOfMassHeadImpl::forward(const Tensor& points, const Tensor& point_mask) {
  const Tensor middle = centroid(points, point_mask);
  const Tensor radius = bounding_radius(points, point_mask, middle).clamp_min(1e-6).unsqueeze(-1);
  const Tensor local = (points - middle.unsqueeze(2)) / radius.unsqueeze(2);
  const Tensor f = torch::silu(layer3(torch::silu(layer2(torch::silu(layer1(local))))));  // [B, K, N, 256]
  const Tensor invalid = point_mask.logical_not().unsqueeze(-1);
  const Tensor largest = f.masked_fill(invalid, -1.0).amax(2);  // silu > -1
  const Tensor mean = centroid(f, point_mask);
  return middle + radius * output(torch::cat({largest, mean}, -1));
}

}  // namespace rigidformer
