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

/// Largest difference between back-propagated and central-difference gradients of a fixed random projection of f()
/// with respect to every element of every leaf (float64), relative to the largest gradient.
inline double gradient_error(const std::function<torch::Tensor()>& f, const std::vector<torch::Tensor>& leaves,
                             double step = 1e-6) {
  torch::Tensor weight;
  const auto project = [&] {
    const torch::Tensor y = f();
    if (!weight.defined()) weight = torch::cos(torch::arange(y.numel(), torch::kFloat64) * 1.7 + 0.3).view(y.sizes());
    return (y * weight).sum();
  };
  const std::vector<torch::Tensor> gradients = torch::autograd::grad({project()}, leaves);
  torch::NoGradGuard no_grad;
  double error = 0.0, largest = 1e-3;
  for (size_t i = 0; i < leaves.size(); ++i) {
    double* values = leaves[i].data_ptr<double>();
    const torch::Tensor analytic = gradients[i].contiguous();
    for (int64_t j = 0; j < leaves[i].numel(); ++j) {
      const double value = values[j];
      values[j] = value + step;
      const double above = project().item<double>();
      values[j] = value - step;
      const double below = project().item<double>();
      values[j] = value;
      const double numeric = (above - below) / (2.0 * step);
      error = std::max(error, std::abs(numeric - analytic.data_ptr<double>()[j]));
      largest = std::max(largest, std::abs(numeric));
    }
  }
  return error / largest;
}

}  // namespace rigidformer
