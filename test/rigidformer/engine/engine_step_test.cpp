// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/engine_step.hpp"

#include <gtest/gtest.h>

#include "rigidformer/engine/cubes.hpp"
#include "rigidformer/model/base_motion.hpp"
#include "rigidformer/model/random_scene.hpp"
#include "rigidformer/scene/mean_material.hpp"
#include "rigidformer/simulation/bullet_world.hpp"
#include "rigidformer/simulation/convex_hull.hpp"

namespace rigidformer {
namespace {

/// Cubes that the engine moves.
struct EngineCubes : Cubes {
  using Cubes::Cubes;

  EngineStep engine() const { return make_engine_step(engine_options(), batch, centre); }

  /// Engine steps that feed on each other.
  Pose roll_out(int num_steps) const {
    const EngineStep step = engine();
    SceneState now = state;
    for (int i = 0; i < num_steps; ++i) {
      const EngineMotion motion = step(now).front();
      now.previous = motion.departure;
      now.current = motion.pose;
    }
    return now.current;
  }

  double height(const Pose& pose, std::int64_t k) const { return pose.translation[0][k][2].item<double>(); }
};

TEST(EngineStep, ModelsWithoutEngineHaveNone) {
  EXPECT_FALSE(make_engine_step(model_preset("tiny"), EngineCubes(1).batch, EngineCubes(1).centre));
}

TEST(EngineStep, FreeFlightIsTheBaseMotion) {
  RandomScene scene = random_scene(2, {{9, 12}, {8}});
  scene.batch.ground_height.fill_(kNoGround);
  const Tensor apart = torch::tensor({{0.0, 0.0, 0.0}, {20.0, 0.0, 0.0}}, torch::kFloat64);
  const Tensor shift = apart - scene.state.current.translation;
  for (Pose* pose : {&scene.state.previous, &scene.state.current}) pose->translation = pose->translation + shift;
  const Tensor centre = 0.1 * torch::randn({2, 2, 3}, torch::kFloat64);
  const EngineMotion motion = make_engine_step(engine_options(), scene.batch, centre)(scene.state).front();
  const BaseMotion base = make_base_motion(engine_options(), scene.batch, scene.state, centre);
  const auto expect_near = [valid = scene.batch.object_mask](const Pose& a, const Pose& b) {
    EXPECT_LT(largest_difference(a.translation.index({valid}), b.translation.index({valid})), 2e-3);
    EXPECT_LT(largest_difference(a.rotation.index({valid}), b.rotation.index({valid})), 2e-3);  // single precision
  };
  expect_near(motion.pose, base.pose);
  expect_near(motion.departure, scene.state.current);
}

TEST(EngineStep, TheGroundIsTheOneThatIsToldElseMovis) {
  EngineCubes cubes(1);
  cubes.place(0, {0.0, 0.0, 0.5005}, {2.0, 0.0, 0.0});
  const auto slid_m = [&] { return cubes.roll_out(6).translation[0][0][0].item<double>(); };
  const double untold = slid_m();
  cubes.batch.ground_material = torch::tensor({{0.3, 0.5}}, torch::kFloat64);
  cubes.batch.ground_known = torch::zeros({1, 2}, torch::kFloat64);
  EXPECT_EQ(slid_m(), untold);
  cubes.batch.ground_known.fill_(1.0);
  EXPECT_NEAR(slid_m(), untold, 1e-6);
  cubes.batch.ground_material[0][0] = 1.0;
  EXPECT_LT(slid_m(), untold - 0.02);
}

TEST(EngineStep, VelocityIsCarriedThroughImpacts) {
  EngineCubes cubes(1);
  cubes.place(0, {0.0, 0.0, 0.75}, {0.5, 0.0, -4.0});
  BulletSettings settings;
  settings.substeps = 1;
  BulletWorld world(settings);
  const double first_kick = 0.5 * 10.0 / kFrameRateHz, half_step = 0.5 * 10.0 * kTimeStep_s;
  BodyState start;
  start.T_world_object.translation = {0.0, 0.0, 0.75};
  start.velocity = {0.5, 0.0, -4.0 - half_step + first_kick};
  Points corners(8, 3);
  for (int i = 0; i < 8; ++i) corners.row(i) << (i & 1) - 0.5F, ((i >> 1) & 1) - 0.5F, ((i >> 2) & 1) - 0.5F;
  world.add_body({"cube", 1.0, {convex_hull(corners)}}, 1.0, {1.0, 0.5, 0.5}, start);
  for (int steps = 1; steps <= 5; ++steps) {
    for (int frame = 0; frame < 10; ++frame) world.step_frame();
    const Eigen::Vector3d expected = world.state(0).T_world_object.translation;
    const Pose actual = cubes.roll_out(steps);
    EXPECT_NEAR(cubes.height(actual, 0), expected.z(), 2e-3) << steps;
    EXPECT_NEAR(actual.translation[0][0][0].item<double>(), expected.x(), 2e-3) << steps;
  }
  EXPECT_GT(cubes.height(cubes.roll_out(3), 0), cubes.height(cubes.roll_out(2), 0));  // it did bounce
}

TEST(EngineStep, WhatLiesStaysWhereItIs) {
  EngineCubes cubes(1);
  cubes.place(0, {1.0, 2.0, 0.501}, {0.0, 0.0, 0.0});
  const Pose after = cubes.roll_out(24);
  EXPECT_LT(largest_difference(after.translation, cubes.state.current.translation), 2e-3);
  EXPECT_LT(largest_difference(after.rotation, cubes.state.current.rotation), 2e-3);
}

TEST(EngineStep, GivenMotionPushesAndIsNotPushed) {
  EngineCubes cubes(2);
  cubes.place(0, {0.0, 0.0, 5.0}, {3.0, 0.0, 0.0});
  cubes.place(1, {1.05, 0.0, 5.0}, {0.0, 0.0, 0.0});
  cubes.batch.dynamic_mask[0][0] = false;
  const EngineMotion motion = cubes.engine()(cubes.state).front();
  EXPECT_NEAR(motion.pose.translation[0][0][0].item<double>(), 3.0 * kTimeStep_s, 1e-4);
  EXPECT_NEAR(cubes.height(motion.pose, 0), 5.0, 1e-4);  // gravity does not move it
  EXPECT_GT(motion.pose.translation[0][1][0].item<double>(), 1.05 + 0.05);
}

TEST(EngineStep, TheGroundIsWhereTheSceneHasIt) {
  EngineCubes cubes(1);
  cubes.place(0, {0.0, 0.0, 2.501}, {0.0, 0.0, 0.0});
  cubes.batch.ground_height.fill_(2.0);
  EXPECT_NEAR(cubes.height(cubes.roll_out(10), 0), 2.5, 5e-3);
  cubes.batch.ground_height.fill_(kNoGround);
  EXPECT_LT(cubes.height(cubes.roll_out(10), 0), 2.0);
}

TEST(EngineStep, OnlyRatiosOfMassesMatter) {
  const auto after_collision = [](double unit_kg) {
    EngineCubes cubes(2);
    cubes.place(0, {0.0, 0.0, 0.5}, {3.0, 0.0, 0.0});
    cubes.place(1, {1.1, 0.2, 0.7}, {-1.0, 0.0, 0.0});
    cubes.batch.properties[0][0][0] = unit_kg;
    cubes.batch.properties[0][1][0] = 2.0 * unit_kg;
    return cubes.roll_out(4);
  };
  const Pose grams = after_collision(0.001), tons = after_collision(1000.0);
  EXPECT_LT(largest_difference(grams.translation, tons.translation), 1e-4);
  EXPECT_LT(largest_difference(grams.rotation, tons.rotation), 1e-4);
}

TEST(EngineStep, UnknownMaterialIsTheMeanOfTheScenes) {
  const auto slides = [](const Tensor& properties, double known) {
    EngineCubes cubes(1);
    cubes.place(0, {0.0, 0.0, 0.5}, {2.0, 0.0, -1.0});
    cubes.batch.properties.copy_(properties);
    cubes.batch.properties_known.fill_(known);
    return cubes.roll_out(4);
  };
  const Pose means = slides(torch::tensor({kMeanDensity, kMeanFriction, kMeanRestitution}, torch::kFloat64), 1.0);
  const Pose unknown = slides(torch::zeros({3}, torch::kFloat64), 0.0);
  const Pose smoother = slides(torch::tensor({kMeanDensity, 0.5, kMeanRestitution}, torch::kFloat64), 1.0);
  EXPECT_EQ(largest_difference(unknown.translation, means.translation), 0.0);
  EXPECT_EQ(largest_difference(unknown.rotation, means.rotation), 0.0);
  EXPECT_GT(largest_difference(unknown.translation, smoother.translation), 1e-3);
}

TEST(EngineStep, ImpossibleSpeedsStayFinite) {
  EngineCubes cubes(2);
  cubes.place(0, {0.0, 0.0, 2.0}, {0.0, 0.0, -1e38});
  cubes.place(1, {0.0, 0.0, 0.5}, {0.0, 0.0, 0.0});
  const Pose after = cubes.roll_out(3);
  EXPECT_TRUE(torch::isfinite(after.translation).all().item<bool>());
  EXPECT_TRUE(torch::isfinite(after.rotation).all().item<bool>());
}

TEST(EngineStep, BatchAndOneByOneAgree) {
  EngineCubes first(2), second(2);
  first.place(0, {0.0, 0.0, 0.7}, {0.0, 0.0, -3.0});
  first.place(1, {0.2, 0.0, 2.0}, {0.0, 0.0, -5.0});
  second.place(0, {0.0, 0.0, 1.5}, {2.0, 0.0, 0.0});
  second.place(1, {1.3, 0.1, 1.6}, {-2.0, 0.0, 0.0});
  EngineCubes both = first;
  const auto join = [](Tensor& a, const Tensor& b) { a = torch::cat({a, b}); };
  for (auto member : {&SceneBatch::points_reference, &SceneBatch::point_mask, &SceneBatch::object_mask,
                      &SceneBatch::dynamic_mask, &SceneBatch::properties, &SceneBatch::properties_known,
                      &SceneBatch::step_size, &SceneBatch::ground_height, &SceneBatch::gravity}) {
    join(both.batch.*member, second.batch.*member);
  }
  join(both.centre, second.centre);
  for (auto pose : {&SceneState::first, &SceneState::previous, &SceneState::current}) {
    join((both.state.*pose).rotation, (second.state.*pose).rotation);
    join((both.state.*pose).translation, (second.state.*pose).translation);
  }
  const Pose together = both.roll_out(4), a = first.roll_out(4), b = second.roll_out(4);
  EXPECT_EQ(largest_difference(together.translation, torch::cat({a.translation, b.translation})), 0.0);
  EXPECT_EQ(largest_difference(together.rotation, torch::cat({a.rotation, b.rotation})), 0.0);
}

/// Moves the engine's share of a step, the last of the anchors' outputs.
void trust_engine(RigidFormer& model, double logit) {
  torch::NoGradGuard no_grad;
  model->named_parameters()["predictor.head.second.bias"].slice(0, 6).fill_(logit);
}

TEST(EngineStep, ItsShareCanBeFixed) {
  RandomScene scene = random_scene(1, {{20, 9, 16}});
  RigidFormer model = random_model(engine_options());
  trust_engine(model, -2.0);
  model->options.contact_gate = false;
  const Tensor centre = model->centre_of_mass(scene.batch, scene.state.current);
  const EngineMotion engine = make_engine_step(model->options, scene.batch, centre)(scene.state).front();
  const auto distance = [&](std::optional<double> share) {
    model->fixed_engine_share = share;
    return largest_difference(predict(model, scene).pose.translation, engine.pose.translation);
  };
  EXPECT_LT(distance(1.0), 1e-9);
  EXPECT_GT(distance({}), 1e-3);
  EXPECT_GT(distance(0.0), distance({}));
}

TEST(EngineStep, TheNetworkCanLeaveAStepToItEntirely) {
  RandomScene scene = random_scene(1, {{20, 9, 16}});
  RigidFormer model = random_model(engine_options());
  model->options.contact_gate = false;
  const Tensor centre = model->centre_of_mass(scene.batch, scene.state.current);
  const EngineMotion engine = make_engine_step(model->options, scene.batch, centre)(scene.state).front();
  const auto distance = [&](double logit) {
    trust_engine(model, logit);
    return largest_difference(predict(model, scene).pose.translation, engine.pose.translation);
  };
  EXPECT_GT(distance(-2.0), 1e-3);
  EXPECT_LT(distance(5.0), 1e-9);
}

TEST(EngineStep, TheNetworkReadsAndUsesIt) {
  RandomScene scene = random_scene(1, {{20, 9, 16}});
  RigidFormer model = random_model(engine_options());
  const Tensor centre = model->centre_of_mass(scene.batch, scene.state.current);
  EXPECT_THROW(model->forward(scene.batch, scene.state, centre, nearest_by_distance_matrix), std::invalid_argument);
  torch::NoGradGuard no_grad;
  const StepPrediction prediction = predict(model, scene);
  const auto moved = [&](const SceneState& state) {
    EngineMotion motion{state.current, state.current};
    motion.pose.translation = motion.pose.translation + 0.1;
    return std::vector<EngineMotion>{motion};
  };
  const StepPrediction other =
      model->forward(scene.batch, scene.state, centre, nearest_by_distance_matrix, EngineStep(moved));
  EXPECT_GT(largest_difference(other.pose.translation, prediction.pose.translation), 1e-3);
  EXPECT_GT(largest_difference(other.departure.translation, prediction.departure.translation), 1e-4);
}

TEST(EngineStep, P36_AnObjectWithoutABodyIsNamed) {
  EngineCubes cubes(3);
  cubes.batch.points_reference[0][1] += 1e12;  // single precision has no room for a cube there
  try {
    cubes.engine();
    FAIL() << "there is no such body";
  } catch (const BodyError& error) {
    EXPECT_EQ(error.object(), 1);
    EXPECT_NE(std::string(error.what()), "");
  }
}

}  // namespace
}  // namespace rigidformer
