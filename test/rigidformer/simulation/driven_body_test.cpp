// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "driven_cube.hpp"

namespace rigidformer {
namespace {

SceneRecording by_bullet(const DrivenCube& driven, int num_frames, int first_frame = 0) {
  return simulate(driven.scene, builtin_shapes(), BulletSettings(), num_frames, first_frame, driven.paths);
}

const auto kByBullet = [](const DrivenCube& driven, int num_frames) { return by_bullet(driven, num_frames); };

TEST(DrivenBodies, APushedCubeMovesWithItsPusher) { expect_a_pushed_cube_moves_with_its_pusher(kByBullet); }

TEST(DrivenBodies, AGrippedCubeIsLiftedAndFallsAfterRelease) { expect_a_gripped_cube_is_lifted_and_falls(kByBullet); }

TEST(DrivenBodies, StaticBodiesCarryAndNeverMove) { expect_static_bodies_carry_and_never_move(kByBullet); }

TEST(DrivenBodies, APalmLiftsWhatLiesOnIt) { expect_a_palm_lifts_what_lies_on_it(kByBullet); }

TEST(DrivenBodies, PathsBeginWithTheRecording) {
  DrivenCube driven;
  driven.add_driven(0.5, straight({-3.0, 0.0, 0.501}, {-2.0, 0.0, 0.501}, 0.0, 0.5));
  const SceneRecording late = by_bullet(driven, 121, 100);
  EXPECT_NEAR(late.objects[1].T_world_object.front().translation.x(), -3.0, 1e-6);
  EXPECT_NEAR(late.objects[1].T_world_object.back().translation.x(), -2.0, 1e-6);
}

TEST(DrivenBodies, PassThroughTheFloorAndThroughEachOther) {
  DrivenCube driven;
  driven.add_driven(0.5, straight({3.0, 0.0, 0.0}, {5.0, 0.0, -1.0}, 0.0, 1.0));
  driven.add_driven(0.5, straight({5.0, 0.0, 0.0}, {3.0, 0.0, -1.0}, 0.0, 1.0));
  const SceneRecording recorded = by_bullet(driven, 240);
  EXPECT_NEAR(recorded.objects[1].T_world_object.back().translation.x(), 5.0, 0.01);
  EXPECT_NEAR(recorded.objects[2].T_world_object.back().translation.z(), -1.0, 0.01);
}

}  // namespace
}  // namespace rigidformer
