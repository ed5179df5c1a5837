// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/tensor_random.hpp"

namespace rigidformer {

TensorRandom::TensorRandom(const torch::Device& device, std::uint64_t seed)
    : generator_(at::globalContext().defaultGenerator(device).clone()) {
  generator_->set_current_seed(seed);
}

}  // namespace rigidformer
