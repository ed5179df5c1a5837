// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/mujoco_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/movi_scene.hpp"

namespace rigidformer {
namespace {

/// A built-in shape as a body at a height, at rest.
MujocoBody body_of(const std::string& name, double height_m, const BodyProperties& properties) {
  for (const Shape& shape : builtin_shapes()) {
    if (shape.name != name) continue;
    MujocoBody body{shape.parts, properties, {}};
    body.state.T_world_object.translation.z() = height_m;
    return body;
  }
  throw std::invalid_argument(name);
}

BodyState after(MujocoWorld& world, int frames) {
  for (int i = 0; i < frames; ++i) world.step_frame();
  return world.state(0);
}

TEST(MujocoWorld, AShapeOfManyPartsTurnsAboutItsOriginInFreeFlight) {
  MujocoBody body = body_of("torus_knot", 6.0, {1.0, 0.4, 0.3});
  body.state.velocity = {1.0, -2.0, 0.5};
  body.state.angular_velocity = {0.5, 3.0, -1.0};
  const MujocoSettings settings;
  MujocoWorld world(settings, {body});
  EXPECT_LT((world.state(0).angular_velocity - body.state.angular_velocity).norm(), 1e-9);
  const BodyState state = after(world, 120);
  const double t = 0.5, h = 1.0 / (240.0 * settings.substeps);
  const Eigen::Vector3d expected(t, -2.0 * t, 6.0 + 0.5 * t - 5.0 * t * (t + h));
  EXPECT_LT((state.T_world_object.translation - expected).norm(), 1e-6);
  EXPECT_LT((state.velocity - Eigen::Vector3d(1.0, -2.0, 0.5 - 10.0 * t)).norm(), 1e-6);
}

/// Speed after the first impact of a dropped ball over the speed before it.
double rebound(const MujocoSettings& settings, double restitution) {
  MujocoWorld world(settings, {body_of("sphere", 1.5, {1.0, 0.4, restitution})});
  double before = 0.0;
  for (int frame = 0; frame < 240; ++frame) {
    const double vertical = after(world, 1).velocity.z();
    before = std::min(before, vertical);
    if (vertical <= 0.2) continue;
    constexpr int kFrames = 5;  // a soft contact takes longer than a frame
    return (after(world, kFrames).velocity.z() + 10.0 * kFrames / 240.0) / -before;
  }
  return 0.0;
}

TEST(MujocoWorld, ReboundsWithTheProductOfBothRestitutionsHoweverSoft) {
  MujocoSettings settings;
  settings.floor_restitution = 0.9;
  for (const double steps : {8.0, 12.0, 20.0}) {
    settings.steps_per_contact = steps;
    for (const double restitution : {0.4, 0.7, 1.0}) {
      EXPECT_NEAR(rebound(settings, restitution), 0.9 * restitution, 0.07) << steps << " steps";
    }
  }
}

TEST(MujocoWorld, ASlidingCubeStopsWhereTheFrictionOfBothSaysSo) {
  MujocoSettings settings;
  settings.floor_friction = 0.8;
  MujocoBody cube = body_of("cube", 0.5, {2.0, 0.5, 0.0});
  cube.state.velocity = {3.0, 0.0, 0.0};
  MujocoWorld world(settings, {cube});
  const BodyState state = after(world, 360);
  EXPECT_LT(state.velocity.norm(), 0.02);
  EXPECT_NEAR(state.T_world_object.translation.x(), 9.0 / (2.0 * 0.4 * 10.0), 0.06);
}

TEST(MujocoWorld, RollingFrictionStopsABallThatRolledOnWithout) {
  MujocoSettings settings;
  MujocoBody ball = body_of("sphere", 0.5, {1.0, 0.8, 0.0});
  ball.state.velocity = {1.0, 0.0, 0.0};
  ball.state.angular_velocity = {0.0, 2.0, 0.0};
  MujocoWorld rolls(settings, {ball});
  EXPECT_GT(after(rolls, 480).velocity.x(), 0.3);
  settings.rolling_friction = 0.5;
  MujocoWorld resists(settings, {ball});
  EXPECT_LT(after(resists, 480).velocity.norm(), 0.05);
}

TEST(MujocoWorld, ShapesOfManyPartsComeToRestOnTheFloor) {
  for (const Shape& shape : builtin_shapes()) {
    MujocoWorld world({}, {{shape.parts, {1.0, 0.5, 0.2}, {}}, body_of("cube", 4.0, {1.0, 0.5, 0.2})});
    EXPECT_FALSE(world.has_diverged()) << shape.name;
    EXPECT_EQ(world.num_bodies(), 2);
  }
  MujocoWorld world({}, {body_of("gear", 1.2, {1.0, 0.6, 0.2})});
  const BodyState state = after(world, 720);
  EXPECT_LT(state.velocity.norm(), 0.05);
  EXPECT_GT(state.T_world_object.translation.z(), 0.05);
}

TEST(MujocoWorld, ATiltedFloorMakesThingsSlide) {
  MujocoSettings settings;
  settings.gravity = {1.0, 0.0, -9.0};
  settings.floor_friction = 0.0;
  MujocoWorld world(settings, {body_of("cube", 0.5, {1.0, 0.5, 0.0})});
  EXPECT_NEAR(after(world, 240).velocity.x(), 1.0, 0.02);
}

TEST(MujocoWorld, RecordsAScene) {
  const std::vector<Shape> shapes = movi_shapes(MoviSet::kA, builtin_shapes());
  const SceneRecording start = sample_movi_scene(MoviSet::kA, shapes, 5, 0);
  MujocoSettings settings;
  settings.floor_friction = 0.7;
  const SceneRecording all = simulate(start, shapes, settings, 30), late = simulate(start, shapes, settings, 10, 20);
  ASSERT_EQ(all.objects.size(), start.objects.size());
  EXPECT_EQ(all.num_frames, 30);
  EXPECT_EQ(all.ground, (GroundProperties{0.7, 0.5}));
  for (std::size_t i = 0; i < all.objects.size(); ++i) {
    EXPECT_EQ(all.objects[i].T_world_object[0].translation, start.objects[i].T_world_object[0].translation);
    EXPECT_EQ(all.objects[i].T_world_object[29].translation, late.objects[i].T_world_object[9].translation);
  }
}

TEST(MujocoWorld, RefusesWhatIsIncomplete) {
  EXPECT_THROW(MujocoWorld({}, {{{}, {1.0, 0.5, 0.5}, {}}}), std::invalid_argument);
  EXPECT_THROW(MujocoWorld({}, {body_of("cube", 1.0, {1.0, std::nullopt, 0.5})}), std::invalid_argument);
  MujocoSettings settings;
  settings.substeps = 0;
  EXPECT_THROW(MujocoWorld(settings, {body_of("cube", 1.0, {1.0, 0.5, 0.5})}), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
