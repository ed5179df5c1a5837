// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "rigidformer/model/rigidformer.hpp"

namespace rigidformer {

/// Copies weights into a model with the same layers, with layers that have more inputs or outputs, or with further
/// layers. New inputs and outputs start at zero, so that an extended model begins as the one it comes from; further
/// layers stay as they are. Throws std::invalid_argument naming the tensor that `to` lacks or that is smaller there.
void transfer_weights(const RigidFormer& from, RigidFormer& to);

/// Copies the weights of a checkpoint; also throws what load_checkpoint() throws.
void transfer_weights(const std::filesystem::path& file, RigidFormer& to);

}  // namespace rigidformer
