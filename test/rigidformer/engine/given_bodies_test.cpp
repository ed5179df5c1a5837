// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "rigidformer/engine/cubes.hpp"
#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/engine/solid_scene.hpp"
#include "rigidformer/model/base_motion.hpp"
#include "rigidformer/model/given_motion.hpp"

namespace rigidformer {
namespace {

Tensor place_at(double x, double y, double z) { return torch::tensor({x, y, z}, torch::kFloat64); }

double coordinate(const Pose& pose, std::int64_t k, std::int64_t axis) {
  return pose.translation[0][k][axis].item<double>();
}

/// Cubes of which some are driven; `coming(step)` tells where they are after that step.
Pose drive(const Cubes& cubes, int num_steps, const std::function<void(int step, Pose& coming)>& coming) {
  const EngineStep step = make_engine_step(engine_options(), cubes.batch, cubes.centre);
  SceneState now = cubes.state;
  for (int i = 1; i <= num_steps; ++i) {
    now.coming = {now.current.rotation.clone(), now.current.translation.clone()};
    coming(i, now.coming);
    const EngineMotion motion = step(now).front();
    now = advance(cubes.batch, now, {Tensor(), motion.pose, motion.departure});
  }
  return now.current;
}

TEST(GivenBodies, WhatRestsOnAShelfDoesNotSink) {
  Cubes cubes(2);
  cubes.place(0, {0.0, 0.0, 3.0}, {0.0, 0.0, 0.0});
  cubes.place(1, {0.0, 0.0, 4.002}, {0.0, 0.0, 0.0});
  cubes.batch.dynamic_mask[0][0] = false;
  const EngineStep step = make_engine_step(engine_options(), cubes.batch, cubes.centre);
  const EngineMotion motion = step(cubes.state).front();
  EXPECT_NEAR(coordinate(motion.pose, 1, 2), 4.002, 5e-4) << "half a step of fall is 9 mm";
  EXPECT_NEAR(coordinate(motion.departure, 1, 2), coordinate(motion.pose, 1, 2), 1e-3) << "nor does it gain speed";
}

TEST(GivenBodies, AStackIsCarriedAndAFallingStackIsNot) {
  Cubes cubes(2);
  const auto carried = [&](double height) {
    const SolidScene scene(make_solids(cubes.batch, cubes.centre), 0.0);
    return scene.carried({{Eigen::Quaterniond::Identity(), {0.0, 0.0, height}},
                          {Eigen::Quaterniond::Identity(), {0.0, 0.0, height + 1.002}}},
                         {0.0, 0.0});
  };
  EXPECT_EQ(carried(0.501), (std::vector<bool>{true, true}));
  EXPECT_EQ(carried(5.0), (std::vector<bool>{false, false}));
}

TEST(GivenBodies, WhatARisingPlatformCarriesRisesWithIt) {
  Cubes cubes(2);
  cubes.place(0, {0.0, 0.0, 3.0}, {0.0, 0.0, 0.5});
  cubes.place(1, {0.0, 0.0, 4.002}, {0.0, 0.0, 0.5});
  cubes.batch.dynamic_mask[0][0] = false;
  const Pose after = drive(cubes, 10, [](int step, Pose& coming) {
    coming.translation[0][0].copy_(place_at(0.0, 0.0, 3.0 + 0.5 * kTimeStep_s * step));
  });
  EXPECT_NEAR(coordinate(after, 1, 2) - coordinate(after, 0, 2), 1.002, 5e-3);
}

TEST(GivenBodies, TheComingPoseIsKnownToBaseMotionEngineAndStep) {
  Cubes cubes(1);
  cubes.place(0, {0.0, 0.0, 3.0}, {0.0, 0.0, 0.0});
  cubes.batch.dynamic_mask[0][0] = false;
  SceneState state = cubes.state;
  state.coming = {state.current.rotation.clone(), place_at(0.2, 0.0, 3.0).reshape({1, 1, 3})};
  for (const ModelOptions& options : {engine_options(), model_preset("tiny")}) {
    const BaseMotion base = make_base_motion(options, cubes.batch, state, cubes.centre);
    EXPECT_LT(
        largest_difference(base.apply(cubes.batch.points_reference), state.coming.apply(cubes.batch.points_reference)),
        1e-12);
    EXPECT_NEAR(base.centre_step[0][0][0].item<double>(), 0.2, 1e-12);
  }
  const EngineMotion motion = make_engine_step(engine_options(), cubes.batch, cubes.centre)(state).front();
  EXPECT_NEAR(coordinate(motion.pose, 0, 0), 0.2, 1e-4);
  const SceneState after = advance(cubes.batch, state, {Tensor(), motion.pose, motion.departure});
  EXPECT_EQ(coordinate(after.current, 0, 0), 0.2);
  EXPECT_FALSE(after.coming.rotation.defined()) << "each step has its own";
}

TEST(GivenBodies, TwoThatCloseOnACubeHoldAndLiftIt) {
  Cubes cubes(3);
  cubes.place(0, {0.0, 0.0, 0.501}, {0.0, 0.0, 0.0});
  cubes.place(1, {-1.02, 0.0, 0.8}, {0.0, 0.0, 0.0});
  cubes.place(2, {1.02, 0.0, 0.8}, {0.0, 0.0, 0.0});
  cubes.batch.dynamic_mask[0][1] = cubes.batch.dynamic_mask[0][2] = false;
  const auto squeeze_and_lift = [](int step, Pose& coming) {
    const double closing = std::min(step, 10) * 0.003, lifted = std::max(step - 10, 0) * 0.02;
    coming.translation[0][1].copy_(place_at(-1.02 + closing, 0.0, 0.8 + lifted));
    coming.translation[0][2].copy_(place_at(1.02 - closing, 0.0, 0.8 + lifted));
  };
  const Pose after = drive(cubes, 40, squeeze_and_lift);
  EXPECT_NEAR(coordinate(after, 0, 0), 0.0, 0.012) << "squeezed by 10 mm on each side, it stays in between";
  EXPECT_NEAR(coordinate(after, 0, 1), 0.0, 0.01);
  EXPECT_NEAR(coordinate(after, 0, 2), 0.501 + 30 * 0.02, 0.03) << "friction lifts it";
  EXPECT_NEAR(coordinate(after, 1, 2), 0.8 + 30 * 0.02, 1e-9) << "what is given is not pushed";
}

TEST(GivenBodies, GapsTellPairsAndTheGround) {
  Cubes cubes(2);
  const SolidScene scene(make_solids(cubes.batch, cubes.centre), 0.0);
  const auto gaps = scene.gaps(
      {{Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.502}}, {Eigen::Quaterniond::Identity(), {0.0, 0.0, 1.45}}}, 0.004);
  ASSERT_EQ(gaps.size(), 2u);
  EXPECT_EQ(gaps[0].partner, -1);
  EXPECT_NEAR(gaps[0].gap_m, 0.002, 1e-5);
  EXPECT_EQ(gaps[1].body, 1);
  EXPECT_EQ(gaps[1].partner, 0);
  EXPECT_NEAR(gaps[1].gap_m, -0.052, 1e-5);
  EXPECT_NEAR(gaps[1].normal.z(), 1.0, 1e-6);
}

}  // namespace
}  // namespace rigidformer
