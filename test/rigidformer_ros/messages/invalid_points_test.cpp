// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/invalid_points.hpp"

#include <gtest/gtest.h>

#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

using testing::blob;

TEST(InvalidPointsTest, P52_points_at_the_sensor_are_none) {
  Points points = blob(30);
  points.row(3).setZero();
  points.row(17) << -0.0F, 0.0F, 0.0F;
  EXPECT_EQ(mask_invalid_points(points, InvalidPoints::kAtOrigin), 2U);
  EXPECT_EQ(rigidformer::finite_rows(points).size(), 28U);
  EXPECT_FALSE(points.row(3).allFinite());
}

TEST(InvalidPointsTest, P52_a_value_that_many_pixels_share_is_none) {
  Points points = blob(300);
  const Eigen::RowVector3f end_of_range(0.0F, 0.0F, 9.999F);
  for (int i = 0; i < 40; ++i) {
    points.row(i * 7) = end_of_range;
  }
  Points as_simulated = points;
  EXPECT_EQ(mask_invalid_points(points, InvalidPoints::kAlsoRepeated), 40U);
  EXPECT_EQ(mask_invalid_points(as_simulated, InvalidPoints::kAtOrigin), 0U);
}

TEST(InvalidPointsTest, P52_vertices_that_faces_share_stay) {
  Points points = blob(200);
  for (int i = 1; i < 9; ++i) {
    points.row(i) = points.row(0);
  }
  EXPECT_EQ(mask_invalid_points(points, InvalidPoints::kAlsoRepeated), 0U);
}

TEST(InvalidPointsTest, NothingOfNothing) {
  Points none(0, 3);
  EXPECT_EQ(mask_invalid_points(none, InvalidPoints::kAlsoRepeated), 0U);
}

}  // namespace
}  // namespace rigidformer_ros
