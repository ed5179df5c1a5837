// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/farthest_point_sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>

namespace rigidformer {
namespace {

Points random_cloud(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> coordinate(0.0F, 1.0F);
  Points points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    points.data()[i] = coordinate(random);
  }
  return points;
}

float squared_distance_to(const Points& points, const std::vector<int>& chosen, std::size_t num_chosen, int row) {
  float best = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < num_chosen; ++k) {
    best = std::min(best, (points.row(chosen[k]) - points.row(row)).squaredNorm());
  }
  return best;
}

TEST(FarthestPointOrder, StartsFarthestFromTheCentroidAndStaysGreedy) {
  const Points points = random_cloud(80, 1);
  const std::vector<int> order = farthest_point_order(points, 80);
  const Eigen::RowVector3f centroid = points.colwise().mean();
  for (int row = 0; row < 80; ++row) {
    EXPECT_LE((points.row(row) - centroid).norm(), (points.row(order[0]) - centroid).norm() + 1e-6F);
  }
  for (std::size_t k = 1; k < order.size(); ++k) {
    for (int row = 0; row < 80; ++row) {
      EXPECT_LE(squared_distance_to(points, order, k, row), squared_distance_to(points, order, k, order[k]) + 1e-6F);
    }
  }
}

TEST(FarthestPointOrder, IsAPermutationWhenAllAreAsked) {
  const std::vector<int> order = farthest_point_order(random_cloud(33, 2), 1000);
  EXPECT_EQ(order.size(), 33U);
  EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), 33U);
}

TEST(FarthestPointOrder, AShorterOrderIsThePrefixOfALonger) {
  const Points points = random_cloud(60, 3);
  const std::vector<int> all = farthest_point_order(points, 60);
  const std::vector<int> some = farthest_point_order(points, 15);
  EXPECT_EQ(some, std::vector<int>(all.begin(), all.begin() + 15));
}

TEST(FarthestPointOrder, DoesNotDependOnPointOrderOrFrame) {
  const Points points = random_cloud(50, 4);
  std::vector<int> shuffle(50);
  std::iota(shuffle.begin(), shuffle.end(), 0);
  std::shuffle(shuffle.begin(), shuffle.end(), std::mt19937(5));
  Points shuffled(50, 3);
  for (int row = 0; row < 50; ++row) {
    shuffled.row(row) = points.row(shuffle[row]);
  }
  const RigidTransform T{Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized())),
                         {1, -2, 3}};
  const std::vector<int> order = farthest_point_order(points, 20);
  const std::vector<int> other = farthest_point_order(T.apply(shuffled), 20);
  for (std::size_t k = 0; k < order.size(); ++k) {
    EXPECT_EQ(shuffle[other[k]], order[k]);
  }
}

TEST(FarthestPointOrder, NeverRepeatsAmongEqualPoints) {
  const std::vector<int> order = farthest_point_order(Points::Ones(10, 3), 10);
  EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), 10U);
}

TEST(FarthestPointOrder, HandlesTheEdges) {
  EXPECT_TRUE(farthest_point_order(Points(0, 3), 4).empty());
  EXPECT_TRUE(farthest_point_order(random_cloud(5, 6), 0).empty());
  EXPECT_THROW(farthest_point_order(random_cloud(5, 6), -1), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
