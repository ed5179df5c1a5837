// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/point_rows.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rigidformer {
namespace {

TEST(PointRowsTest, FindsAndSelectsTheFiniteRows) {
  Points points = Points::Ones(4, 3);
  points(1, 2) = std::numeric_limits<float>::quiet_NaN();
  points(3, 0) = std::numeric_limits<float>::infinity();
  points.row(2) << 4.0F, 5.0F, 6.0F;
  const std::vector<int> rows = finite_rows(points);
  EXPECT_EQ(rows, (std::vector<int>{0, 2}));
  const Points selected = select_rows(points, rows);
  ASSERT_EQ(selected.rows(), 2);
  EXPECT_EQ(selected.row(1), points.row(2));
}

TEST(PointRowsTest, NothingOfNothing) {
  EXPECT_TRUE(finite_rows(Points(0, 3)).empty());
  EXPECT_EQ(select_rows(Points::Ones(2, 3), {}).rows(), 0);
}

}  // namespace
}  // namespace rigidformer
