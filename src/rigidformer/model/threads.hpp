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

/// The processor that the linear-algebra library chose its inner loops for; empty when it does not say.
std::string linear_algebra_core();

/// OpenBLAS takes processors newer than itself for a Pentium 4 ("Prescott"), a fifth as fast: this makes it choose
/// again among the loops for the vector units that are there. Does nothing when it knows the processor, when it was
/// built for one kind only, or when the environment variable OPENBLAS_CORETYPE is set, which has its way. Nothing else
/// in the process may multiply with OpenBLAS or read the environment meanwhile: programs call this before they start
/// threads. Predictor and training call it too, for programs that do not; in a nodelet manager that is once, when the
/// first model loads. May be called again and from several threads.
void use_vector_units();

}  // namespace rigidformer
