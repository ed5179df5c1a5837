// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace rigidformer {

/// Sets the number of CPU threads of tensor operations and of the linear-algebra library behind them, which keeps a
/// thread pool of its own. One thread is best whenever anything else runs on the machine.
void set_num_threads(int num_threads);

/// Lets the allocator keep freed memory: tensors of a few MB come and go every step, and handing them back to the
/// system each time costs a third of the run. Memory stays bounded by its peak.
void keep_freed_memory();

/// The processor that the linear-algebra library chose its inner loops for; empty when it does not say. OpenBLAS takes
/// processors newer than itself for a Pentium 4 ("Prescott"), a fifth as fast: when this library is loaded, it makes
/// OpenBLAS use the loops for the vector units that are there. The environment variable OPENBLAS_CORETYPE has its way.
std::string linear_algebra_core();

}  // namespace rigidformer
