// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace rigidformer {

/// A float64 leaf with random values that takes part in a gradient check.
inline torch::Tensor random_leaf(torch::IntArrayRef shape) {
  return torch::randn(shape, torch::kFloat64).set_requires_grad(true);
}

/// Largest difference between back-propagated and central-difference derivatives of a fixed projection of f(), along
/// random directions of every leaf (float64) in turn, relative to the largest derivative.
inline double gradient_error(const std::function<torch::Tensor()>& f, const std::vector<torch::Tensor>& leaves,
                             double step = 1e-6) {
  constexpr int kDirectionsPerLeaf = 3;  // random directions; chosen by eye
  const auto project = [&] {
    const torch::Tensor y = f();
    return (y * torch::cos(torch::arange(y.numel(), torch::kFloat64) * 1.7 + 0.3).view(y.sizes())).sum();
  };
  const std::vector<torch::Tensor> gradients = torch::autograd::grad({project()}, leaves);
  torch::NoGradGuard no_grad;
  double error = 0.0, largest = 1e-3;
  for (size_t i = 0; i < leaves.size(); ++i) {
    torch::Tensor leaf = leaves[i];
    const torch::Tensor start = leaf.detach().clone();
    for (int k = 0; k < kDirectionsPerLeaf; ++k) {
      const torch::Tensor direction = torch::randn_like(start);
      leaf.copy_(start + step * direction);
      const double above = project().item<double>();
      leaf.copy_(start - step * direction);
      const double below = project().item<double>();
      leaf.copy_(start);
      const double numeric = (above - below) / (2.0 * step);
      error = std::max(error, std::abs(numeric - (gradients[i] * direction).sum().item<double>()));
      largest = std::max(largest, std::abs(numeric));
    }
  }
  return error / largest;
}

}  // namespace rigidformer
