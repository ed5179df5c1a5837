// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/observed_motion.hpp"

#include <gtest/gtest.h>

#include "rigidformer/scene/mean_material.hpp"

namespace rigidformer {
namespace {

constexpr double kTimeStep_s = 10.0 / 240.0;
constexpr double kGravity = -9.81;

TEST(ObservedMotion, AWorldTakesOneStepPerFrameOnTheGroundThatIsKnown) {
  const BulletSettings settings = observed_world(kTimeStep_s, kGravity, {0.9, std::nullopt});
  EXPECT_DOUBLE_EQ(settings.frame_rate_hz, 24.0);
  EXPECT_EQ(settings.substeps, 10);
  EXPECT_EQ(settings.gravity, Eigen::Vector3d(0.0, 0.0, kGravity));
  EXPECT_EQ(settings.floor_friction, 0.9);
  EXPECT_EQ(settings.floor_restitution, kGroundRestitution);
  EXPECT_EQ(observed_world(0.001, kGravity, {}).substeps, 1);
}

TEST(ObservedMotion, FreeFallIsSeenWithTheVelocityOfItsEnd) {
  const auto height = [](double t) { return 5.0 + 2.0 * t + 0.5 * kGravity * t * t; };
  RigidTransform before, now;
  before.translation.z() = height(0.0);
  now.translation.z() = height(kTimeStep_s);
  now.rotation = rotation_about(kTimeStep_s * Eigen::Vector3d(1.0, -2.0, 0.5));
  const BodyState state = mean_motion(before, now, kTimeStep_s);
  EXPECT_NEAR(state.velocity.z() + half_fall(kTimeStep_s, kGravity), 2.0 + kGravity * kTimeStep_s, 1e-9);
  EXPECT_LT((state.angular_velocity - Eigen::Vector3d(1.0, -2.0, 0.5)).norm(), 1e-9);
  EXPECT_EQ(state.T_world_object.translation, now.translation);
}

TEST(ObservedMotion, TheFloorIsTouchedByTheLowestPoint) {
  Points points(2, 3);
  points << 0.0F, 0.0F, 0.5F, 0.0F, 0.0F, -0.5F;
  RigidTransform T_ground_body;
  T_ground_body.translation.z() = 0.509;
  EXPECT_TRUE(touches_floor(points, T_ground_body));
  T_ground_body.translation.z() = 0.511;
  EXPECT_FALSE(touches_floor(points, T_ground_body));
}

TEST(ObservedMotion, OnlyWhatIsUnknownIsReplacedByMeans) {
  const BodyProperties none = with_means({}, 0.2);
  EXPECT_EQ(*none.mass_kg, 0.2 * kMeanDensity);
  EXPECT_EQ(*none.friction, kMeanFriction);
  EXPECT_EQ(*none.restitution, kMeanRestitution);
  const BodyProperties some = with_means({{}, {0.1}, {}}, 0.2);
  EXPECT_EQ(*some.friction, 0.1);
  EXPECT_EQ(*some.restitution, kMeanRestitution);
}

// The shipped model was trained with these stand-ins: other numbers would be another engine than the one it knows.
TEST(ObservedMotion, MeansAreThoseOfTheShippedModel) {
  EXPECT_EQ(kMeanDensity, 1.0);
  EXPECT_EQ(kMeanFriction, 0.6);
  EXPECT_EQ(kMeanRestitution, 0.5);
  EXPECT_EQ(kGroundFriction, 0.3);
  EXPECT_EQ(kGroundRestitution, 0.5);
}

}  // namespace
}  // namespace rigidformer
