// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace rigidformer {

/// Sets the number of CPU threads of tensor operations and of the linear-algebra library behind them, which keeps a
/// thread pool of its own. One thread is best whenever anything else runs on the machine.
void set_num_threads(int num_threads);

/// Lets the allocator keep freed memory: tensors of a few MB come and go every step, and handing them back to the
/// system each time costs a third of the run. Memory stays bounded by its peak.
void keep_freed_memory();

}  // namespace rigidformer
