// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/threads.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <torch/torch.h>

#include <cstdlib>
#include <mutex>

// Present when LibTorch was built with OpenBLAS; resolved at load time, null otherwise.
extern "C" {
void openblas_set_num_threads(int num_threads) __attribute__((weak));
char* openblas_get_corename() __attribute__((weak));
void gotoblas_dynamic_init() __attribute__((weak));
void gotoblas_dynamic_quit() __attribute__((weak));
}

namespace rigidformer {
namespace {

constexpr const char* kCoreVariable = "OPENBLAS_CORETYPE";
constexpr const char* kOldestCore = "Prescott";  // what OpenBLAS says when it does not know the processor

/// OpenBLAS's name for the loops that suit the vector units, null for old processors.
const char* core_for_vector_units() {
#if defined(__x86_64__) && defined(__GNUC__)
  __builtin_cpu_init();
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  if (avx512) return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
#endif
  return nullptr;
}

}  // namespace

std::string linear_algebra_core() { return openblas_get_corename != nullptr ? openblas_get_corename() : ""; }

void use_vector_units() {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  const bool can_choose = gotoblas_dynamic_init != nullptr && gotoblas_dynamic_quit != nullptr;
  const char* core = core_for_vector_units();
  const bool is_unknown = linear_algebra_core() == kOldestCore;
  if (!can_choose || core == nullptr || !is_unknown || std::getenv(kCoreVariable) != nullptr) return;
  setenv(kCoreVariable, core, 1);  // OpenBLAS reads it whenever it starts, not only when it is loaded
  gotoblas_dynamic_quit();
  gotoblas_dynamic_init();
  unsetenv(kCoreVariable);
}

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
