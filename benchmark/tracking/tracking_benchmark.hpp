// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace rigidformer {

/// Seed of the first series of clouds of each shape in the benchmarks `track/...`; further series count up from there.
extern std::uint64_t tracking_seed;

}  // namespace rigidformer
