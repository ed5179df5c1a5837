// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include "rigidformer/io/tensor_file.hpp"

namespace rigidformer {

/// Copies a tensor (any device, any strides) into raw bytes, stored as `type`.
RawTensor to_raw(const torch::Tensor& tensor, TensorType type);

/// Copies raw bytes into a CPU tensor of the stored type.
torch::Tensor from_raw(const RawTensor& raw);

}  // namespace rigidformer
