// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/breakdown.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "rigidformer/evaluation/scene_results.hpp"

namespace rigidformer {
namespace {

const RoundKey kRound{"toys", 120, 10, "bullet"};

class BreakdownTest : public testing::Test {
 protected:
  const SceneRecording small_ = resting_scene("small", {"cube", "ball"}, 200);
  const SceneRecording large_ = resting_scene("large", {"cube", "cube", "ball"}, 200);
  Breakdown breakdown_;
};

TEST_F(BreakdownTest, ShapesAreRootMeanSquaresOverObjects) {
  breakdown_.add(result_of("bullet", small_, {0.0, 0.0}, {{3.0, 10.0}, {1.0, 2.0}}));
  breakdown_.add(result_of("bullet", large_, {0.0, 0.0}, {{4.0, 10.0}, {5.0, 20.0}, {1.0, 14.0}}));
  const auto shapes = breakdown_.by_shape().at(kRound);
  ASSERT_EQ(shapes.size(), 2U);
  EXPECT_EQ(shapes.at("cube").count, 3);
  EXPECT_DOUBLE_EQ(shapes.at("cube").error.position_rmse_m, std::sqrt(50.0 / 3.0));
  EXPECT_DOUBLE_EQ(shapes.at("cube").error.orientation_rmse_deg, std::sqrt(200.0));
  EXPECT_EQ(shapes.at("ball").count, 2);
  EXPECT_DOUBLE_EQ(shapes.at("ball").error.position_rmse_m, 1.0);
  EXPECT_DOUBLE_EQ(shapes.at("ball").error.orientation_rmse_deg, 10.0);
}

TEST_F(BreakdownTest, NumbersOfObjectsAreMeansOverScenes) {
  breakdown_.add(result_of("bullet", small_, {0.25, 10.0}, {{}, {}}));
  breakdown_.add(result_of("bullet", small_, {0.75, 20.0}, {{}, {}}));
  breakdown_.add(result_of("bullet", large_, {2.0, 30.0}, {{}, {}, {}}));
  breakdown_.add(result_of("mujoco", small_, {9.0, 90.0}, {{}, {}}));
  const auto counts = breakdown_.by_num_objects().at(kRound);
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_EQ(counts.at(2).count, 2);
  EXPECT_DOUBLE_EQ(counts.at(2).error.position_rmse_m, 0.5);
  EXPECT_DOUBLE_EQ(counts.at(2).error.orientation_rmse_deg, 15.0);
  EXPECT_EQ(counts.at(3).count, 1);
  EXPECT_DOUBLE_EQ(counts.at(3).error.position_rmse_m, 2.0);
  EXPECT_EQ(breakdown_.by_num_objects().size(), 2U);  // one round for each model
}

TEST_F(BreakdownTest, FramesCountFromTheStartAndMeanOverTheScenesThatReachThem) {
  SceneResult long_one = result_of("bullet", small_, {}, {{}, {}});
  long_one.curve = {{10, {0.0, 0.0}}, {20, {1.0, 4.0}}, {30, {2.0, 8.0}}};
  SceneResult short_one = long_one;
  short_one.curve = {{10, {0.0, 0.0}}, {20, {3.0, 8.0}}};
  breakdown_.add(long_one);
  breakdown_.add(short_one);
  const auto frames = breakdown_.by_frame().at(kRound);
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames.at(10).count, 2);
  EXPECT_DOUBLE_EQ(frames.at(20).error.position_rmse_m, 2.0);
  EXPECT_DOUBLE_EQ(frames.at(20).error.orientation_rmse_deg, 6.0);
  EXPECT_EQ(frames.at(30).count, 1);
  EXPECT_DOUBLE_EQ(frames.at(30).error.position_rmse_m, 2.0);
}

TEST_F(BreakdownTest, RefusesResultsWithoutHorizons) {
  SceneResult result = result_of("bullet", small_, {}, {{}, {}});
  result.at_horizon.clear();
  EXPECT_THROW(breakdown_.add(result), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
