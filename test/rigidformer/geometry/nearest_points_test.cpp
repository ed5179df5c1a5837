// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/nearest_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace rigidformer {
namespace {

using Poses = std::vector<RigidTransform>;

Points random_cloud(int count, float half_size, std::mt19937& random) {
  std::uniform_real_distribution<float> coordinate(-half_size, half_size);
  Points points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    points.data()[i] = coordinate(random);
  }
  return points;
}

RigidTransform random_pose(double half_size, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-half_size, half_size);
  const Eigen::Vector3d turn(coordinate(random), coordinate(random), coordinate(random));
  const Eigen::AngleAxisd rotation(turn.norm(), turn.normalized());
  return {Eigen::Quaterniond(rotation), {coordinate(random), coordinate(random), coordinate(random)}};
}

double distance(const Eigen::RowVector3f& a, const Eigen::RowVector3f& b) { return (a - b).cast<double>().norm(); }

double nearest_other_distance(const std::vector<Points>& world, std::size_t object, Eigen::Index row) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < world.size(); ++j) {
    for (Eigen::Index k = 0; j != object && k < world[j].rows(); ++k) {
      best = std::min(best, distance(world[object].row(row), world[j].row(k)));
    }
  }
  return best;
}

/// Compares distances and not indices, because two points may be equally near to within rounding.
void expect_exact(const std::vector<Points>& clouds, const Poses& poses, const std::vector<NearestNeighbors>& nearest) {
  std::vector<Points> world;
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    world.push_back(poses[i].apply(clouds[i]));
  }
  ASSERT_EQ(nearest.size(), clouds.size());
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    ASSERT_EQ(nearest[i].object.size(), static_cast<std::size_t>(clouds[i].rows()));
    ASSERT_EQ(nearest[i].point.size(), static_cast<std::size_t>(clouds[i].rows()));
    for (Eigen::Index row = 0; row < clouds[i].rows(); ++row) {
      const int j = nearest[i].object[row];
      ASSERT_GE(j, 0);
      ASSERT_NE(j, static_cast<int>(i));
      ASSERT_LT(nearest[i].point[row], clouds[j].rows());
      EXPECT_NEAR(distance(world[i].row(row), world[j].row(nearest[i].point[row])),
                  nearest_other_distance(world, i, row), 2e-5);
    }
  }
}

TEST(NearestPoints, MatchesBruteForceOnRandomScenes) {
  std::mt19937 random(1);
  for (int scene = 0; scene < 20; ++scene) {
    std::vector<Points> clouds;
    Poses poses;
    for (int count : {1, 7, 60, 200, 33}) {
      clouds.push_back(random_cloud(count, 0.7F, random));
      poses.push_back(random_pose(0.3 + 0.2 * scene, random));
    }
    NearestPoints search(clouds);
    std::vector<NearestNeighbors> nearest;
    search.query(poses, nearest);
    expect_exact(clouds, poses, nearest);
  }
}

TEST(NearestPoints, StaysExactWhileObjectsMove) {
  std::mt19937 random(2);
  std::vector<Points> clouds;
  Poses poses;
  for (int i = 0; i < 6; ++i) {
    clouds.push_back(random_cloud(40 + 30 * i, 0.7F, random));
    poses.push_back(random_pose(2.0, random));
  }
  NearestPoints search(clouds);
  std::vector<NearestNeighbors> nearest;
  for (int step = 0; step < 30; ++step) {
    for (RigidTransform& pose : poses) {  // small motions, with a jump now and then that makes the last answer useless
      pose = step % 10 == 9 ? random_pose(2.0, random) : random_pose(0.05, random) * pose;
    }
    search.query(poses, nearest);
    expect_exact(clouds, poses, nearest);
  }
}

TEST(NearestPoints, FindsCoincidingPointsOfTouchingObjects) {
  std::mt19937 random(3);
  const Points cloud = random_cloud(100, 0.5F, random);
  NearestPoints search({cloud, cloud});
  std::vector<NearestNeighbors> nearest;
  search.query({RigidTransform{}, RigidTransform{}}, nearest);
  for (int row = 0; row < 100; ++row) {
    EXPECT_EQ(nearest[0].object[row], 1);
    EXPECT_EQ(nearest[0].point[row], row);
    EXPECT_EQ(nearest[1].point[row], row);
  }
}

TEST(NearestPoints, AcceptsCloudsOfEqualPoints) {
  const Points dot = Points::Constant(50, 3, 0.25F);
  NearestPoints search({dot, dot});
  std::vector<NearestNeighbors> nearest;
  search.query({RigidTransform{}, RigidTransform{Eigen::Quaterniond::Identity(), {1, 0, 0}}}, nearest);
  EXPECT_EQ(nearest[0].object, std::vector<int>(50, 1));
}

TEST(NearestPoints, AloneObjectHasNoNeighbor) {
  std::mt19937 random(4);
  NearestPoints search({random_cloud(9, 1.0F, random)});
  std::vector<NearestNeighbors> nearest;
  search.query({RigidTransform{}}, nearest);
  EXPECT_EQ(nearest[0].object, std::vector<int>(9, -1));
  EXPECT_EQ(nearest[0].point, std::vector<int>(9, -1));
}

TEST(NearestPoints, EmptySceneGivesNothing) {
  NearestPoints search(std::vector<Points>{});
  std::vector<NearestNeighbors> nearest(3);
  search.query({}, nearest);
  EXPECT_TRUE(nearest.empty());
}

TEST(NearestPoints, RepeatedQueriesKeepTheirBuffers) {
  std::mt19937 random(5);
  NearestPoints search({random_cloud(50, 1.0F, random), random_cloud(70, 1.0F, random)});
  const Poses poses{random_pose(1.0, random), random_pose(1.0, random)};
  std::vector<NearestNeighbors> nearest;
  search.query(poses, nearest);
  const int* buffer = nearest[0].object.data();
  const std::vector<int> first = nearest[0].point;
  search.query(poses, nearest);
  EXPECT_EQ(nearest[0].object.data(), buffer);
  EXPECT_EQ(nearest[0].point, first);
}

TEST(NearestPoints, RefusesBrokenInput) {
  Points broken = Points::Zero(4, 3);
  broken(2, 1) = std::nanf("");
  EXPECT_THROW(NearestPoints({broken}), std::invalid_argument);
  EXPECT_THROW(NearestPoints({Points(0, 3)}), std::invalid_argument);
  NearestPoints search({Points::Zero(4, 3)});
  std::vector<NearestNeighbors> nearest;
  EXPECT_THROW(search.query({}, nearest), std::invalid_argument);
  RigidTransform lost;
  lost.translation.x() = std::nan("");
  EXPECT_THROW(search.query({lost}, nearest), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
