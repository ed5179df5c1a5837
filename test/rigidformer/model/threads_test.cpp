// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/threads.hpp"

#include <gtest/gtest.h>
#include <torch/torch.h>

#include <cstdlib>

namespace rigidformer {
namespace {

TEST(Threads, LinearAlgebraUsesTheVectorUnitsOfTheProcessor) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && std::getenv("OPENBLAS_CORETYPE") == nullptr) {
    EXPECT_NE(linear_algebra_core(), "Prescott");
  }
#endif
  const torch::Tensor a = torch::randn({70, 50}, torch::kFloat64), b = torch::randn({50, 90}, torch::kFloat64);
  const torch::Tensor sum = (a.unsqueeze(-1) * b.unsqueeze(0)).sum(1);
  EXPECT_LT((torch::mm(a, b) - sum).abs().max().item<double>(), 1e-12);
}

}  // namespace
}  // namespace rigidformer
