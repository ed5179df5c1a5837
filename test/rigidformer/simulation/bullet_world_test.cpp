// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/bullet_world.hpp"

#include <gtest/gtest.h>

#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/movi_scene.hpp"

namespace rigidformer {
namespace {

const Shape& builtin(const std::string& name) {
  for (const Shape& shape : builtin_shapes()) {
    if (shape.name == name) return shape;
  }
  throw std::invalid_argument(name);
}

BodyState at(double x, double y, double z) {
  BodyState state;
  state.T_world_object.translation = {x, y, z};
  return state;
}

const BodyProperties kRubber{1.0, 0.8, 0.7};

TEST(BulletWorld, FreeFlightIsAParabolaWithConstantHorizontalVelocity) {
  const BulletSettings settings;
  BulletWorld world(settings);
  BodyState start = at(0, 1, 4);
  start.velocity = {2.0, -1.0, 0.5};
  world.add_body(builtin("pear"), 1.0, kRubber, start);
  const double h = 1.0 / (settings.frame_rate_hz * settings.substeps);
  for (int frame = 1; frame <= 100; ++frame) {
    world.step_frame();
    const BodyState state = world.state(0);
    const double t = frame / settings.frame_rate_hz;
    // The solver's parabola has t (t + h) instead of t^2, because it changes first the velocity and then the position.
    const Eigen::Vector3d expected(2.0 * t, 1.0 - t, 4.0 + 0.5 * t - 5.0 * t * (t + h));
    ASSERT_LT((state.T_world_object.translation - expected).norm(), 1e-3) << "frame " << frame;
    ASSERT_LT((state.velocity - Eigen::Vector3d(2.0, -1.0, 0.5 - 10.0 * t)).norm(), 1e-3) << "frame " << frame;
  }
}

TEST(BulletWorld, CollisionInTheAirConservesMomentum) {
  BulletWorld world(BulletSettings{});
  BodyState left = at(-1.2, 0, 5);
  left.velocity = {4, 0, 0};
  world.add_body(builtin("cube"), 1.0, {2.0, 0.4, 0.3}, left);
  world.add_body(builtin("torus"), 1.2, {0.7, 0.8, 0.7}, at(0.3, 0.2, 5.1));
  for (int frame = 0; frame < 100; ++frame) world.step_frame();
  EXPECT_GT((world.state(0).velocity - Eigen::Vector3d(4, 0, -10 * 100 / 240.0)).norm(), 0.1) << "they never met";
  const Eigen::Vector3d momentum = 2.0 * world.state(0).velocity + 0.7 * world.state(1).velocity;
  EXPECT_LT((momentum - Eigen::Vector3d(8, 0, -2.7 * 10 * 100 / 240.0)).norm(), 0.01) << momentum.transpose();
}

TEST(BulletWorld, ACubeComesToRestOnTheFloor) {
  BulletWorld world(BulletSettings{});
  world.add_body(builtin("cube"), 1.0, {1.0, 0.4, 0.0}, at(0, 0, 1));
  for (int frame = 0; frame < 480; ++frame) world.step_frame();
  EXPECT_NEAR(world.state(0).T_world_object.translation.z(), 0.5, 5e-3);
  EXPECT_LT(world.state(0).velocity.norm(), 0.02);
}

/// The ball after two seconds on the floor, on which it first spins and rolls.
BodyState ball_after_two_seconds(const BulletSettings& settings) {
  BulletWorld world(settings);
  BodyState start = at(0, 0, 0.5);
  start.velocity = {1.0, 0.0, 0.0};
  start.angular_velocity = {0.0, 2.0, 4.0};
  world.add_body(builtin("sphere"), 1.0, {1.0, 0.8, 0.0}, start);
  for (int frame = 0; frame < 480; ++frame) world.step_frame();
  return world.state(0);
}

TEST(BulletWorld, SpinningAndRollingFrictionStopABallThatWentOnWithout) {
  BulletSettings settings;
  EXPECT_GT(ball_after_two_seconds(settings).velocity.x(), 0.7);
  EXPECT_GT(ball_after_two_seconds(settings).angular_velocity.z(), 2.5);
  settings.rolling_friction = settings.spinning_friction = 0.5;
  EXPECT_LT(ball_after_two_seconds(settings).velocity.norm(), 0.05);
  EXPECT_LT(ball_after_two_seconds(settings).angular_velocity.norm(), 0.1);
}

TEST(BulletWorld, OverlapsAreSeenByShapeNotByBox) {
  BulletWorld world(BulletSettings{});
  world.add_body(builtin("torus"), 1.0, kRubber, at(0, 0, 3));
  const int ball = world.add_body(builtin("sphere"), 0.4, kRubber, at(0, 0, 3));
  EXPECT_FALSE(world.overlaps_any(ball)) << "the ball is in the hole of the ring";
  world.set_state(ball, at(0.6, 0, 3));
  EXPECT_TRUE(world.overlaps_any(ball));
  world.remove_last_body();
  EXPECT_EQ(world.num_bodies(), 1);
  EXPECT_FALSE(world.overlaps_any(0));
}

TEST(BulletWorld, ContinuesFromAnyFrameOfARecording) {
  const std::vector<Shape> shapes = movi_shapes(MoviSet::kA, builtin_shapes());
  const BulletSettings settings = movi_bullet_settings(MoviSet::kA);
  const SceneRecording scene = simulate(sample_movi_scene(MoviSet::kA, shapes, 5, 0), shapes, settings, 60);
  BulletWorld world = make_world(scene, shapes, settings, 10);
  ASSERT_EQ(world.num_bodies(), static_cast<int>(scene.objects.size()));
  for (int frame = 10; frame < 20; ++frame) world.step_frame();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const RigidTransform now = world.state(static_cast<int>(i)).T_world_object;
    EXPECT_LT((now.translation - scene.objects[i].T_world_object[20].translation).norm(), 1e-3);
  }
  EXPECT_THROW(make_world(scene, shapes, settings, 60), std::invalid_argument);
  EXPECT_THROW(make_world(scene, {}, settings), std::invalid_argument);
}

TEST(BulletWorld, BadValuesAreRefused) {
  BulletSettings settings;
  settings.substeps = 0;
  EXPECT_THROW(BulletWorld{settings}, std::invalid_argument);
  BulletWorld world(BulletSettings{});
  EXPECT_THROW(world.add_body(builtin("cube"), 0.0, kRubber, {}), std::invalid_argument);
  EXPECT_THROW(world.add_body(builtin("cube"), 1.0, {std::nullopt, 0.4, 0.3}, {}), std::invalid_argument);
  EXPECT_THROW(world.add_body(builtin("cube"), 1.0, {1.0, std::nullopt, 0.3}, {}), std::invalid_argument);
  EXPECT_THROW(world.add_body(Shape{"empty", 1.0, {}}, 1.0, kRubber, {}), std::invalid_argument);
  EXPECT_THROW(world.remove_last_body(), std::invalid_argument);
  EXPECT_EQ(world.num_bodies(), 0);
}

}  // namespace
}  // namespace rigidformer
