// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/tensor_random.hpp"

#include <ATen/CPUGeneratorImpl.h>

namespace rigidformer {

namespace {

at::Generator make_generator(const torch::Device& device, std::uint64_t seed) {
  if (device.is_cpu()) {
    return at::detail::createCPUGenerator(seed);
  }
  at::Generator generator = at::globalContext().defaultGenerator(device).clone();  // LibTorch 1.13 never frees a clone
  generator.set_current_seed(seed);
  return generator;
}

}  // namespace

TensorRandom::TensorRandom(const torch::Device& device, std::uint64_t seed)
    : generator_(make_generator(device, seed)) {}

}  // namespace rigidformer
