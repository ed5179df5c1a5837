// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <vector>

#include "euclidean_segmentation.hpp"
#include "rigidformer/geometry/random.hpp"
#include "stable_labels.hpp"

namespace {

using rigidformer::Points;

/// The points of a table with two cubes. The table is a plane of 40 cm with a point every 5 mm. The cubes of 5 cm have
/// points on their surfaces and hang above the table, `gap_m` apart.
Points table_with_cubes(double gap_m) {
  rigidformer::Random random(3);
  std::vector<Eigen::RowVector3f> rows;
  for (int i = 0; i < 80; ++i) {
    for (int j = 0; j < 80; ++j) {
      rows.push_back({0.005F * static_cast<float>(i) - 0.2F, 0.005F * static_cast<float>(j) - 0.2F, 0.0F});
    }
  }
  for (int cube = 0; cube < 2; ++cube) {
    for (int i = 0; i < 400; ++i) {
      Eigen::RowVector3d p(random.uniform(0.0, 0.05), random.uniform(0.0, 0.05), random.uniform(0.0, 0.05));
      p[random.uniform_int(0, 2)] = 0.05 * random.uniform_int(0, 1);
      rows.push_back((p + Eigen::RowVector3d(cube * (0.05 + gap_m), 0.0, 0.05)).cast<float>());
    }
  }
  Points points(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    points.row(static_cast<Eigen::Index>(i)) = rows[i];
  }
  return points;
}

TEST(EuclideanSegmentation, FindsTheObjectsAndLeavesTheGround) {
  const auto objects = find_objects(table_with_cubes(0.05), {});
  ASSERT_EQ(objects.size(), 2U);
  for (const std::vector<int>& rows : objects) {
    EXPECT_EQ(rows.size(), 400U);
    EXPECT_EQ(rows.front() / 400, rows.back() / 400) << "one cube each";
    EXPECT_GE(rows.front(), 6400);
  }
}

TEST(EuclideanSegmentation, WhatIsFartherThanTheRangeIsNoObject) {
  Points points = table_with_cubes(0.05);
  points.bottomRows(400).col(1).array() += 3.0F;  // This moves the second cube away from the camera.
  SegmentationOptions options;
  EXPECT_EQ(find_objects(points, options).size(), 1U);
  options.max_range = 4.0;
  EXPECT_EQ(find_objects(points, options).size(), 2U);
  options.max_range = 0.0;
  EXPECT_EQ(find_objects(points, options).size(), 2U) << "without a limit";
}

// A camera that is near sees many points in each voxel. None of them may be lost or be in the objects twice.
TEST(EuclideanSegmentation, DenseCloudsGoToTheirObjectsPointByPoint) {
  const Points sparse = table_with_cubes(0.05);
  // Copies of every point, all within about a millimetre; chosen by eye to have many points per voxel.
  constexpr int kCopies = 12;
  Points points(kCopies * sparse.rows(), 3);
  for (int copy = 0; copy < kCopies; ++copy) {
    points.middleRows(copy * sparse.rows(), sparse.rows()) = sparse.array() + 1e-4F * static_cast<float>(copy);
  }
  const auto objects = find_objects(points, {});
  ASSERT_EQ(objects.size(), 2U);
  std::set<int> labelled;
  for (const std::vector<int>& rows : objects) {
    labelled.insert(rows.begin(), rows.end());
    EXPECT_EQ(rows.size(), 400U * kCopies);
  }
  EXPECT_EQ(labelled.size(), 800U * kCopies);
}

TEST(EuclideanSegmentation, ObjectsThatTouchAreOne) { EXPECT_EQ(find_objects(table_with_cubes(0.002), {}).size(), 1U); }

TEST(EuclideanSegmentation, WithoutAPlaneNothingIsTakenForGround) {
  Points points = table_with_cubes(0.05).bottomRows(800);
  SegmentationOptions options;
  options.min_plane_share = 0.5;
  const auto objects = find_objects(points, options);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].size() + objects[1].size(), 800U);
}

TEST(EuclideanSegmentation, PointsOnOneSpotHaveNoPlaneWhateverItsShareMayBe) {
  SegmentationOptions options;
  options.min_plane_share = 0.0;
  const auto objects = find_objects(Points::Constant(50, 3, 0.1F), options);
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects.front().size(), 50U);
}

TEST(EuclideanSegmentation, P01_P02_NanAndNearlyEmptyCloudsGiveNoObjects) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(find_objects(Points(0, 3), {}).empty());
  EXPECT_TRUE(find_objects(Points::Constant(500, 3, nan), {}).empty());
  for (const int count : {1, 2, 3, 9}) {
    EXPECT_TRUE(find_objects(Points::Random(count, 3), {}).empty()) << count;
  }
  EXPECT_LE(find_objects(Points::Constant(500, 3, 1.0F), {}).size(), 1U) << "all points equal";
  Points half = table_with_cubes(0.05);
  for (Eigen::Index i = 0; i < half.rows(); i += 2) {
    half.row(i).setConstant(i % 4 == 0 ? nan : std::numeric_limits<float>::infinity());
  }
  EXPECT_EQ(find_objects(half, {}).size(), 2U);
}

TEST(StableLabels, FollowObjectsWhateverTheirOrder) {
  StableLabels labels(0.1, 2);
  EXPECT_EQ(labels.assign({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(labels.assign({{1.05, 0.0, 0.0}, {0.05, 0.0, 0.0}}), (std::vector<std::uint32_t>{2, 1}));
}

TEST(StableLabels, TheNearestPairWins) {
  StableLabels labels(1.0, 2);
  labels.assign({{0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}});
  EXPECT_EQ(labels.assign({{0.45, 0.0, 0.0}}), (std::vector<std::uint32_t>{2}));
}

TEST(StableLabels, P11_VanishedObjectsComeBackOrAreForgotten) {
  StableLabels labels(0.1, 2);
  labels.assign({{0.0, 0.0, 0.0}});
  EXPECT_TRUE(labels.assign({}).empty());
  EXPECT_TRUE(labels.assign({}).empty());
  EXPECT_EQ(labels.assign({{0.0, 0.0, 0.05}}), (std::vector<std::uint32_t>{1})) << "two frames missed";
  for (int i = 0; i < 3; ++i) {
    labels.assign({});
  }
  EXPECT_EQ(labels.assign({{0.0, 0.0, 0.05}}), (std::vector<std::uint32_t>{2})) << "a label is never used again";
}

TEST(StableLabels, AFarObjectIsANewOne) {
  StableLabels labels(0.1, 2);
  labels.assign({{0.0, 0.0, 0.0}});
  EXPECT_EQ(labels.assign({{0.2, 0.0, 0.0}}), (std::vector<std::uint32_t>{2}));
}

}  // namespace
