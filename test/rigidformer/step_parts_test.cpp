// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/step_parts.hpp"

#include <gtest/gtest.h>

#include "rigidformer/engine/cubes.hpp"
#include "rigidformer/model/scene_input.hpp"

#ifdef RIGIDFORMER_HAS_SIMULATION
namespace rigidformer {
namespace {

using Rows = std::vector<std::int64_t>;

/// The parts of a step in which all cubes sleep but the last one.
StepParts parts_of(const Cubes& cubes) {
  const SolidScene scene(make_solids(cubes.batch, cubes.centre), 0.0);
  const auto poses = [&](const Pose& pose) { return scene.body_poses(to_world(pose, Eigen::Vector3d::Zero())); };
  std::vector<bool> asleep(scene.solids().size(), true);
  asleep.back() = false;
  const std::vector<RigidTransform> now = poses(cubes.state.current);
  return find_parts(scene, {poses(cubes.state.previous), now, kTimeStep_s, -10.0}, now, asleep);
}

/// Three cubes in a row, 0.3 m apart, and one that moves towards them from the left, `gap_m` away from the first.
Cubes row_of_cubes(double gap_m, double speed_mps, double between_m = 0.3) {
  Cubes cubes(4);
  for (std::int64_t k = 0; k < 3; ++k) {
    const double x = (1.0 + between_m) * static_cast<double>(k);
    cubes.place(k, {x, 0.0, 0.5}, {0.0, 0.0, 0.0});
  }
  cubes.place(3, {-1.0 - gap_m, 0.0, 0.5}, {speed_mps, 0.0, 0.0});
  return cubes;
}

TEST(StepParts, WhatIsFarAwayIsNotSeen) {
  const StepParts parts = parts_of(row_of_cubes(2.0, 3.0));
  EXPECT_EQ(parts.seen, Rows{3});
  EXPECT_EQ(parts.may_move, (std::vector<bool>{false, false, false, true}));
}

TEST(StepParts, WhatIsNearIsSeenAndStays) {
  const StepParts parts = parts_of(row_of_cubes(0.4, 0.0));
  EXPECT_EQ(parts.seen, (Rows{0, 3}));
  EXPECT_FALSE(parts.may_move[0]);
}

TEST(StepParts, WhatMayBeHitMayMoveAndSeesItsNeighbours) {
  const StepParts parts = parts_of(row_of_cubes(0.2, 4.0));  // 0.17 m in a step
  EXPECT_EQ(parts.may_move, (std::vector<bool>{true, false, false, true}))
      << "it is 0.3 m from the first to the second";
  EXPECT_EQ(parts.seen, (Rows{0, 1, 3}));
  EXPECT_TRUE(parts_of(row_of_cubes(0.2, 8.0)).may_move[1]) << "what is hit may come as far as what hits it";
}

TEST(StepParts, AHitGoesThroughAllThatTouches) { EXPECT_TRUE(parts_of(row_of_cubes(0.2, 6.0, 0.002)).is_everybody()); }

TEST(StepParts, WhatIsGivenPassesNothingOn) {
  Cubes cubes = row_of_cubes(0.002, 0.1, 0.002);
  cubes.batch.dynamic_mask[0][0] = false;
  const StepParts parts = parts_of(cubes);
  EXPECT_EQ(parts.may_move, (std::vector<bool>{false, false, false, true}));
  EXPECT_EQ(parts.seen, (Rows{0, 3}));
}

TEST(StepParts, ACornerComesFartherThanTheCentre) {
  Cubes cubes = row_of_cubes(0.2, 0.0);
  const double angle = 0.3;
  const Tensor turned = torch::tensor(
      {std::cos(angle), -std::sin(angle), 0.0, std::sin(angle), std::cos(angle), 0.0, 0.0, 0.0, 1.0}, torch::kFloat64);
  cubes.state.previous.rotation = cubes.state.previous.rotation.clone();
  cubes.state.previous.rotation[0][3] = turned.reshape({3, 3});
  EXPECT_TRUE(parts_of(cubes).may_move[0]);
}

TEST(Sleepers, OnlyWhatWasPutBackAndWhatIsGivenSleeps) {
  Cubes cubes(3);
  cubes.batch.dynamic_mask[0][2] = false;
  cubes.place(1, {3.0, 0.0, 5.0}, {1.0, 0.0, 0.0});
  Sleepers sleepers;
  const auto asleep = [&] { return sleepers.find(cubes.batch, cubes.state); };
  EXPECT_EQ(asleep(), (std::vector<bool>{false, false, false})) << "two equal poses may be of something that falls";
  EXPECT_EQ(asleep(), (std::vector<bool>{true, false, true}));
  cubes.state.current.translation = cubes.state.current.translation + 1e-9;
  cubes.state.previous.translation = cubes.state.current.translation;
  EXPECT_FALSE(asleep()[0]) << "it came here by the last step";
  EXPECT_TRUE(asleep()[0]);
}

}  // namespace
}  // namespace rigidformer
#endif
