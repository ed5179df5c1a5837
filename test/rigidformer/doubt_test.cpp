// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/doubt.hpp"

#include <gtest/gtest.h>

namespace rigidformer {
namespace {

RigidTransform at(double x, double turn_rad = 0.0) {
  return {rotation_about({0.0, 0.0, turn_rad}), Eigen::Vector3d(x, 0.0, 0.0)};
}

TEST(Doubt, SpreadIsThatOfOneCoordinate) {
  const Doubt doubt = spread_of({at(1.0, 0.4), at(1.3, 0.1)});
  EXPECT_NEAR(doubt.position_m, std::sqrt(2.0 * 0.15 * 0.15 / 3.0), 1e-12);
  EXPECT_NEAR(doubt.rotation_rad, std::sqrt(2.0 * 0.15 * 0.15 / 3.0), 1e-9);
  EXPECT_EQ(spread_of({at(1.0), at(1.0)}).position_m, 0.0);
}

TEST(Doubt, ProgressFollowsWhatHappened) {
  const std::vector<RigidTransform> poses{at(0.0), at(0.1), at(0.3), at(0.3)};
  const auto phase = [&](int first_contact, std::size_t step) {
    return progress_of(poses, first_contact, step, 0.05).phase;
  };
  EXPECT_EQ(phase(-1, 3), Phase::kFree);
  EXPECT_EQ(phase(2, 1), Phase::kFree);
  EXPECT_EQ(phase(2, 2), Phase::kContact);
  EXPECT_EQ(phase(2, 3), Phase::kResting);
  EXPECT_EQ(phase(0, 0), Phase::kContact);
  EXPECT_DOUBLE_EQ(progress_of(poses, -1, 3, 0.05).time_s, 0.15);
  EXPECT_DOUBLE_EQ(progress_of(poses, 2, 3, 0.05).time_s, 0.05) << "since the contact";
  EXPECT_DOUBLE_EQ(progress_of(poses, 2, 1, 0.05).speed_mps, 2.0);
  EXPECT_DOUBLE_EQ(progress_of(poses, 2, 3, 0.05).speed_mps, 4.0) << "the largest so far";
  EXPECT_DOUBLE_EQ(progress_of({at(0.0), at(0.0)}, -1, 1, 0.05).speed_mps, kLeastSpeed_mps);
}

TEST(Doubt, SpreadAndTheRestAddUpSquared) {
  const DoubtCell cell{{0.5, 0.6}, {0.03, 0.0}, 2.0, 3.0};
  EXPECT_DOUBLE_EQ(total_doubt(cell, 2.0, {}).position_m, 1.0);
  const Doubt doubt = total_doubt(cell, 1.0, Doubt{0.02, 0.1});
  EXPECT_DOUBLE_EQ(doubt.position_m, 0.05);
  EXPECT_DOUBLE_EQ(doubt.rotation_rad, 0.3);
}

TEST(Doubt, IsFilledInStepByStepForWhatIsPredicted) {
  DoubtTable table;
  for (auto& phases : table.cells) {
    for (auto& cells : phases) cells.fill({{0.1, 0.2}, {}, 1.0, 1.0});
  }
  Forecast forecast;
  forecast.objects = {{"free", {}, {at(0.0)}}, {"given", {}, {at(5.0)}}};
  forecast.times_s = {0.0};
  for (int step = 1; step < 4; ++step) {
    forecast.times_s.push_back(0.04 * step);
    for (ObjectTrajectory& object : forecast.objects) object.poses.push_back(object.poses.back());
    add_doubt(table, {Knowledge::kShape, Knowledge::kShape}, {MotionMode::kDynamic, MotionMode::kKinematic},
              nothing_spreads, forecast);
    ASSERT_EQ(forecast.objects[0].position_stddev_m.size(), forecast.times_s.size());
  }
  EXPECT_DOUBLE_EQ(forecast.objects[0].position_stddev_m[3], 0.1 * kLeastSpeed_mps);
  EXPECT_DOUBLE_EQ(forecast.objects[0].rotation_stddev_rad[3], 0.2 * kLeastSpeed_mps);
  EXPECT_TRUE(forecast.objects[1].position_stddev_m.empty());
}

}  // namespace
}  // namespace rigidformer
