// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <string>

namespace rigidformer {

/// auto | cpu | cuda | cuda:N to a device that works. `auto` prefers CUDA; an explicit CUDA device that is not usable
/// is an error (std::runtime_error), never a silent CPU. Other texts: std::invalid_argument.
torch::Device select_device(const std::string& name);

}  // namespace rigidformer
