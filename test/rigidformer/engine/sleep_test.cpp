// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "rigidformer/engine/cubes.hpp"
#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/model/rest.hpp"

namespace rigidformer {
namespace {

/// States and what pressed after each step of an engine whose resting bodies are held.
struct Rollout {
  std::vector<Pose> poses;
  std::vector<std::vector<PressedPair>> pressed;

  double coordinate(std::size_t step, std::int64_t k, std::int64_t axis) const {
    return poses[step].translation[0][k][axis].item<double>();
  }
};

Rollout roll_out(const Cubes& cubes, int num_steps, Sleep sleep) {
  const EngineStep step = make_engine_step(cubes.batch, make_solids(cubes.batch, cubes.centre), 1, sleep);
  Rollout run;
  SceneState now = cubes.state;
  for (int i = 0; i < num_steps; ++i) {
    const EngineMotion motion = step(now).front();
    SceneState next = advance(cubes.batch, now, {Tensor(), motion.pose, motion.departure});
    hold_resting(cubes.batch, now, next, {});
    run.poses.push_back(next.current);
    run.pressed.push_back(motion.pressed);
    now = next;
  }
  return run;
}

/// A stack of two, a cube that is far away, and a heavy one that flies into the stack after half a second.
Cubes stack_that_is_hit() {
  Cubes cubes(4);
  cubes.place(0, {0.0, 0.0, 0.501}, {0.0, 0.0, 0.0});
  cubes.place(1, {0.0, 0.0, 1.502}, {0.0, 0.0, 0.0});
  cubes.place(2, {8.0, 0.0, 0.501}, {0.0, 0.0, 0.0});
  cubes.place(3, {-5.1, 0.0, 1.6}, {8.0, 0.0, 2.5});
  cubes.batch.properties[0][3][0] = 5.0;
  return cubes;
}

TEST(Sleep, WhatIsHitWakesInTheSameStepAndMovesTheSameWay) {
  const Cubes cubes = stack_that_is_hit();
  const Rollout asleep = roll_out(cubes, 40, Sleep::kWhileHeld), awake = roll_out(cubes, 40, Sleep::kNever);
  std::size_t hit = 0;
  while (hit < 40 && awake.coordinate(hit, 1, 0) < 1e-3) ++hit;
  ASSERT_GT(hit, 5U) << "the stack rests before";
  ASSERT_LT(hit, 30U) << "the stack is hit";
  for (std::size_t i = 0; i < hit; ++i) {
    EXPECT_TRUE(torch::equal(asleep.poses[i].translation, awake.poses[i].translation)) << i;
    EXPECT_TRUE(torch::equal(asleep.poses[i].rotation, awake.poses[i].rotation)) << i;
  }
  // Of bodies that are awake, Bullet keeps contact points: after a hit, the paths part a little.
  EXPECT_GT(asleep.coordinate(hit, 1, 0), 1e-3);
  EXPECT_NEAR(asleep.coordinate(hit + 2, 1, 0) / awake.coordinate(hit + 2, 1, 0), 1.0, 0.1);
  EXPECT_NEAR(asleep.coordinate(hit + 2, 3, 0) - awake.coordinate(hit + 2, 3, 0), 0.0, 0.02);
}

TEST(Sleep, WhatWasWokenGoesOnMovingWithoutWhatWokeIt) {
  const Rollout rollout = roll_out(stack_that_is_hit(), 40, Sleep::kWhileHeld);
  EXPECT_LT(rollout.coordinate(35, 3, 0), 3.5);
  EXPECT_GT(rollout.coordinate(35, 1, 0), 5.0) << "the stack slides on and leaves behind what hit it";
  EXPECT_EQ(rollout.coordinate(35, 2, 0), 8.0) << "what nothing has reached stays";
  EXPECT_GT(rollout.coordinate(39, 2, 0), 8.01) << "until it is hit, too";
}

TEST(Sleep, SleepersStillPress) {
  const auto pressed = roll_out(stack_that_is_hit(), 4, Sleep::kWhileHeld).pressed;
  const auto impulse = [&](std::size_t step, std::int64_t a, std::int64_t b) {
    for (const PressedPair& pair : pressed[step]) {
      if (pair.object == a && pair.partner == b) return pair.normal_impulse_Ns;
    }
    return 0.0;
  };
  EXPECT_NEAR(impulse(3, 0, -1), 2.0 * 10.0 * kTimeStep_s, 0.2) << "two cubes of 1 kg on the ground";
  EXPECT_NEAR(impulse(3, 1, 0), 10.0 * kTimeStep_s, 0.1);
}

}  // namespace
}  // namespace rigidformer
