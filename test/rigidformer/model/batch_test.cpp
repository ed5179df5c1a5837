// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/batch.hpp"

#include <gtest/gtest.h>

namespace rigidformer {
namespace {

// That the list holds all tensors is checked when it is compiled.
TEST(SceneBatch, EveryTensorMoves) {
  SceneBatch batch;
  double number = 0.0;
  for (const auto tensor : kBatchTensors) {
    ASSERT_FALSE((batch.*tensor).defined()) << "twice in the list";
    batch.*tensor = torch::full({2, 3}, ++number);
  }
  const SceneBatch moved = batch.to(torch::kCPU);
  for (const auto tensor : kBatchTensors) {
    ASSERT_TRUE((moved.*tensor).defined());
    EXPECT_TRUE(torch::equal(moved.*tensor, batch.*tensor));
  }
  EXPECT_TRUE(torch::equal(moved.ground_known, torch::full({2, 3}, number))) << "ground_known is the last of the list";
}

TEST(SceneBatch, WhatIsUndefinedStaysSo) {
  SceneBatch batch;
  batch.points_reference = torch::ones({1, 1, 4, 3});
  const SceneBatch moved = batch.to(torch::kCPU);
  EXPECT_TRUE(moved.points_reference.defined());
  EXPECT_FALSE(moved.surface_points.defined());
  EXPECT_FALSE(moved.control.defined());
}

TEST(SceneState, EveryPoseMoves) {
  const auto pose = [](double value) { return Pose{torch::full({1, 1, 3, 3}, value), torch::full({1, 1, 3}, value)}; };
  const SceneState state{pose(1.0), pose(2.0), pose(3.0)};
  const SceneState moved = state.to(torch::kCPU);
  for (const auto member : {&SceneState::first, &SceneState::previous, &SceneState::current}) {
    EXPECT_TRUE(torch::equal((moved.*member).rotation, (state.*member).rotation));
    EXPECT_TRUE(torch::equal((moved.*member).translation, (state.*member).translation));
  }
  EXPECT_FALSE(SceneState().to(torch::kCPU).first.rotation.defined());
}

}  // namespace
}  // namespace rigidformer
