// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/threads.hpp"

#include <gtest/gtest.h>
#include <torch/torch.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>

#include "rigidformer/predictor.hpp"

extern "C" {
void gotoblas_dynamic_init() __attribute__((weak));
void gotoblas_dynamic_quit() __attribute__((weak));
}

namespace rigidformer {
namespace {

constexpr const char* kCoreVariable = "OPENBLAS_CORETYPE";

void restart_openblas() {
  gotoblas_dynamic_quit();
  gotoblas_dynamic_init();
}

/// OpenBLAS as it is on a processor that it does not know; afterwards as it was.
class UnknownProcessor : public ::testing::Test {
 protected:
  void SetUp() override {
#if defined(__x86_64__) && defined(__GNUC__)
    has_vector_units_ = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
    const bool can_choose = gotoblas_dynamic_init != nullptr && gotoblas_dynamic_quit != nullptr;
    if (!has_vector_units_ || !can_choose || std::getenv(kCoreVariable) != nullptr) {
      GTEST_SKIP() << "no OpenBLAS that can choose, or nothing to choose";
    }
    setenv(kCoreVariable, "Prescott", 1);
    restart_openblas();
    unsetenv(kCoreVariable);
    was_changed_ = true;
  }

  void TearDown() override {
    unsetenv(kCoreVariable);
    if (was_changed_) restart_openblas();
  }

  bool has_vector_units_ = false, was_changed_ = false;
};

/// Seconds that the fastest of some matrix products takes.
double product_time_s() {
  const torch::Tensor a = torch::randn({256, 256}), b = torch::randn({256, 256});
  double fastest_s = 1e9;
  for (int i = 0; i < 20; ++i) {
    const auto start = std::chrono::steady_clock::now();
    torch::mm(a, b);
    fastest_s = std::min(fastest_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return fastest_s;
}

TEST_F(UnknownProcessor, TheLibraryAloneChangesNothing) { EXPECT_EQ(linear_algebra_core(), "Prescott"); }

TEST_F(UnknownProcessor, VectorUnitsAreUsedOnRequest) {
  const double slow_s = product_time_s();
  use_vector_units();
  const std::string chosen = linear_algebra_core();
  EXPECT_NE(chosen, "Prescott");
  EXPECT_EQ(std::getenv(kCoreVariable), nullptr) << "children would inherit it";
  const double fast_s = product_time_s();
  RecordProperty("slow_us", std::to_string(1e6 * slow_s));
  RecordProperty("fast_us", std::to_string(1e6 * fast_s));
  use_vector_units();
  EXPECT_EQ(linear_algebra_core(), chosen) << "a second request is none";
}

TEST_F(UnknownProcessor, TheEnvironmentHasItsWay) {
  setenv(kCoreVariable, "Prescott", 1);
  use_vector_units();
  EXPECT_EQ(linear_algebra_core(), "Prescott");
}

TEST_F(UnknownProcessor, APredictorUsesThem) {
  PredictorOptions options;
  options.file = "/nonexistent.safetensors";
  options.device = "cpu";
  EXPECT_THROW(Predictor{options}, std::runtime_error);  // the matrices come after the choice
  EXPECT_NE(linear_algebra_core(), "Prescott");
}

TEST(Threads, ProductsAreRightWithTheChosenLoops) {
  use_vector_units();
  const torch::Tensor a = torch::randn({70, 50}, torch::kFloat64), b = torch::randn({50, 90}, torch::kFloat64);
  const torch::Tensor sum = (a.unsqueeze(-1) * b.unsqueeze(0)).sum(1);
  EXPECT_LT((torch::mm(a, b) - sum).abs().max().item<double>(), 1e-12);
}

}  // namespace
}  // namespace rigidformer
