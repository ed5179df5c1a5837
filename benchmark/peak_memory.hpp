// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace rigidformer {

/// Loads a checkpoint on the CPU in float32, predicts 20 steps of the paper's scene and returns the peak resident
/// memory of this process so far [MiB]. Only meaningful in a process that did nothing else.
double peak_memory_of(const std::string& checkpoint);

}  // namespace rigidformer
