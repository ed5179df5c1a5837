// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <string>

namespace rigidformer {

/// Turns auto, cpu, cuda or cuda:N into a device that works. `auto` prefers CUDA. An explicit CUDA device that is not
/// usable is an error (std::runtime_error), never silently the CPU. Other texts throw std::invalid_argument.
torch::Device select_device(const std::string& name);

}  // namespace rigidformer
