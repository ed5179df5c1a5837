// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "driven_cube.hpp"
#include "rigidformer/simulation/mujoco_world.hpp"

namespace rigidformer {
namespace {

const auto kByMujoco = [](const DrivenCube& driven, int num_frames) {
  return simulate(driven.scene, builtin_shapes(), MujocoSettings(), num_frames, 0, driven.paths);
};

TEST(DrivenBodiesOfMujoco, APushedCubeMovesWithItsPusher) { expect_a_pushed_cube_moves_with_its_pusher(kByMujoco); }

TEST(DrivenBodiesOfMujoco, AGrippedCubeIsLiftedAndFallsAfterRelease) {
  expect_a_gripped_cube_is_lifted_and_falls(kByMujoco);
}

TEST(DrivenBodiesOfMujoco, StaticBodiesCarryAndNeverMove) { expect_static_bodies_carry_and_never_move(kByMujoco); }

TEST(DrivenBodiesOfMujoco, APalmLiftsWhatLiesOnIt) { expect_a_palm_lifts_what_lies_on_it(kByMujoco); }

TEST(DrivenBodiesOfMujoco, NeedAPath) {
  DrivenCube driven;
  driven.add_driven(0.5, straight({3.0, 0.0, 0.5}, {5.0, 0.0, 0.5}, 0.0, 1.0));
  EXPECT_THROW(simulate(driven.scene, builtin_shapes(), MujocoSettings(), 2), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
