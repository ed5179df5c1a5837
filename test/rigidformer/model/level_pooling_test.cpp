// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/level_pooling.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rigidformer {
namespace {

/// Objects of 0, 1, 5 and 11 points.
Tensor mask_of_counts() {
  const Tensor count = torch::tensor({{0, 1}, {5, 11}}, torch::kInt64).unsqueeze(-1);
  return torch::arange(11) < count;
}

Tensor joined(const std::array<Tensor, kLevelFractions.size()>& levels) {
  return torch::cat(torch::TensorList(levels.data(), levels.size()), -1);
}

TEST(LevelPooling, TakesTheMaximaOfTheFirstPoints) {
  const Tensor f = torch::tensor({1.0F, 4.0F, 2.0F, 8.0F, 16.0F, 32.0F, 64.0F, 128.0F}).reshape({1, 1, 8, 1});
  const Tensor pooled = joined(pool_levels(f, torch::ones({1, 1, 8}, torch::kBool)));
  EXPECT_TRUE(torch::equal(pooled.flatten(), torch::tensor({128.0F, 8.0F, 4.0F, 1.0F}))) << pooled;
}

TEST(LevelPooling, OnePassDoesWhatMasksDoWithTheSameGradient) {
  torch::manual_seed(3);
  const Tensor mask = mask_of_counts();
  const Tensor start = torch::randn({2, 2, 11, 7});
  const Tensor one_pass = start.clone().requires_grad_(), by_masks = start.clone().requires_grad_();
  const Tensor weight = torch::randn({2, 2, 28});
  const Tensor a = joined(pool_levels(one_pass, mask)), b = joined(pool_levels_by_masks(by_masks, mask));
  EXPECT_TRUE(torch::equal(a, b));
  (a * weight).sum().backward();
  (b * weight).sum().backward();
  EXPECT_TRUE(torch::allclose(one_pass.grad(), by_masks.grad()));
  EXPECT_GT(one_pass.grad().abs().max().item<float>(), 0.0F);
}

TEST(LevelPooling, WhatIsNotANumberStaysOne) {
  const Tensor f = torch::zeros({1, 1, 4, 1});
  f[0][0][0][0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(joined(pool_levels(f, torch::ones({1, 1, 4}, torch::kBool))).isnan().all().item<bool>());
}

}  // namespace
}  // namespace rigidformer
