// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/random.hpp"

#include <gtest/gtest.h>

namespace rigidformer {
namespace {

TEST(Random, SameSeedAndStreamSameNumbers) {
  Random a(3, 4);
  Random b(3, 4);
  Random other_stream(3, 5);
  Random other_seed(4, 4);
  const double first = a.uniform(0, 1);
  EXPECT_EQ(first, b.uniform(0, 1));
  EXPECT_NE(first, other_stream.uniform(0, 1));
  EXPECT_NE(first, other_seed.uniform(0, 1));
}

TEST(Random, NumbersStayInsideAndFillTheInterval) {
  Random random(1);
  double sum = 0.0;
  int counts[3] = {0, 0, 0};
  for (int i = 0; i < 3000; ++i) {
    const double value = random.uniform(-2.0, 4.0);
    ASSERT_GE(value, -2.0);
    ASSERT_LT(value, 4.0);
    sum += value;
    const int integer = random.uniform_int(5, 7);
    ASSERT_GE(integer, 5);
    ASSERT_LE(integer, 7);
    ++counts[integer - 5];
  }
  EXPECT_NEAR(sum / 3000.0, 1.0, 0.15);
  for (const int count : counts) EXPECT_NEAR(count, 1000, 120);
}

TEST(Random, RotationsAreUnitAndPointEverywhere) {
  Random random(2);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double mean_square_w = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Quaterniond q = random.rotation();
    ASSERT_NEAR(q.norm(), 1.0, 1e-12);
    mean += q * Eigen::Vector3d::UnitX() / 2000.0;
    mean_square_w += q.w() * q.w() / 2000.0;
  }
  EXPECT_LT(mean.norm(), 0.08);
  EXPECT_NEAR(mean_square_w, 0.25, 0.03);  // the mean is a quarter for points uniform on the 3-sphere
}

}  // namespace
}  // namespace rigidformer
