// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

namespace rigidformer {

/// Random tensors from a generator of its own, so that threads do not share one, or from torch's default generators.
class TensorRandom {
 public:
  /// Uses torch's default generators.
  TensorRandom() = default;

  /// Makes a generator on `device`.
  TensorRandom(const torch::Device& device, std::uint64_t seed);

  /// Draws numbers uniformly from [0, 1), of the type and on the device of `like`.
  torch::Tensor uniform(at::IntArrayRef sizes, const torch::TensorOptions& like) const {
    return torch::rand(sizes, generator_, like);
  }
  torch::Tensor normal(at::IntArrayRef sizes, const torch::TensorOptions& like) const {
    return torch::randn(sizes, generator_, like);
  }
  /// Draws integers uniformly from [low, high).
  torch::Tensor integer(std::int64_t low, std::int64_t high, at::IntArrayRef sizes,
                        const torch::TensorOptions& like) const {
    return torch::randint(low, high, sizes, generator_, like);
  }

 private:
  c10::optional<at::Generator> generator_;
};

}  // namespace rigidformer
