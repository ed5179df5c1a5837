// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/threads.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <torch/torch.h>

// Present when LibTorch was built with OpenBLAS; resolved at load time, null otherwise.
extern "C" void openblas_set_num_threads(int num_threads) __attribute__((weak));

namespace rigidformer {

void set_num_threads(int num_threads) {
  torch::set_num_threads(num_threads);
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(num_threads);
}

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

}  // namespace rigidformer
