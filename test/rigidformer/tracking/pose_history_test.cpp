// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/pose_history.hpp"

#include <gtest/gtest.h>

#include "rigidformer/tracking/flying_blob.hpp"

namespace rigidformer {
namespace {

using testing::Flight;

constexpr double kMinDt = 0.005;  // [s] the default of history/min_dt

PoseHistory record(const Flight& flight, const std::vector<double>& times, double start_s = 100.0) {
  PoseHistory history;
  for (const double t : times) {
    history.add(stamp_at(start_s + t), flight.pose(t), kMinDt);
  }
  return history;
}

void expect_pose(const std::optional<RigidTransform>& pose, const RigidTransform& expected) {
  ASSERT_TRUE(pose);
  EXPECT_LT((pose->translation - expected.translation).norm(), 1e-8);
  EXPECT_LT(rotation_angle(pose->rotation, expected.rotation), 1e-7);
}

TEST(PoseHistory, IsExactForConstantVelocityAndSpin) {
  Flight flight;
  flight.gravity = 0.0;
  const PoseHistory history = record(flight, {0.0, 0.033, 0.071, 0.1});
  for (const double t : {0.0, 0.01, 0.05, 0.0999, 0.1}) {
    expect_pose(history.pose_at(stamp_at(100.0 + t)), flight.pose(t));
  }
}

TEST(PoseHistory, IsExactForFreeFallWithThreePoses) {
  const Flight flight;
  const PoseHistory history = record(flight, {0.0, 0.033, 0.071});
  for (const double t : {0.01, 0.04, 0.0709}) {
    expect_pose(history.pose_at(stamp_at(100.0 + t)), flight.pose(t));
  }
}

TEST(PoseHistory, ExtrapolatesOneFrameAndNoMore) {
  Flight flight;
  flight.gravity = 0.0;
  const PoseHistory history = record(flight, {0.0, 0.03});
  expect_pose(history.pose_at(stamp_at(100.0 - 0.029)), flight.pose(-0.029));
  expect_pose(history.pose_before(stamp_at(100.03), 0.059), flight.pose(-0.029));
  EXPECT_FALSE(history.pose_at(stamp_at(100.0 - 0.031)));
  expect_pose(history.pose_at(stamp_at(100.059)), flight.pose(0.059));
  EXPECT_FALSE(history.pose_at(stamp_at(100.061)));
}

TEST(PoseHistory, OnePoseServesItsOwnInstantOnly) {
  const PoseHistory history = record(Flight(), {0.0});
  EXPECT_TRUE(history.pose_at(stamp_at(100.0)));
  EXPECT_FALSE(history.pose_at(stamp_at(100.001)));
}

TEST(PoseHistory, ReachesBeforeTheStartOfTime) {
  Flight flight;
  flight.gravity = 0.0;
  const PoseHistory history = record(flight, {0.0, 0.03}, 0.01);
  expect_pose(history.pose_before(stamp_at(0.04), 0.055), flight.pose(-0.025));
}

TEST(PoseHistory, PredictsAConstantTwist) {
  Flight flight;
  flight.gravity = 0.0;
  EXPECT_EQ(record(flight, {0.0}).predict(stamp_at(103.0)).translation, flight.start) << "no velocity is known";
  const PoseHistory history = record(flight, {0.0, 0.033, 0.071, 0.1});
  for (const double t : {0.1, 0.133, 0.4}) {
    expect_pose(history.predict(stamp_at(100.0 + t)), flight.pose(t));
  }
}

TEST(PoseHistory, PredictsFromTheNewestFrames) {
  const Flight flight;
  const PoseHistory history = record(flight, {0.0, 0.04, 0.08, 0.12});
  const Eigen::Vector3d step = flight.pose(0.12).translation - flight.pose(0.08).translation;
  const Eigen::Vector3d expected = flight.pose(0.12).translation + step;
  EXPECT_LT((history.predict(stamp_at(100.16)).translation - expected).norm(), 1e-8);
}

TEST(PoseHistory, CloseAndRepeatedStampsReplace) {
  const Flight flight;
  const PoseHistory history = record(flight, {0.0, 0.03, 0.03, 0.030000001, 0.034});
  EXPECT_EQ(history.size(), 2U);
  EXPECT_EQ(history.newest_stamp(), stamp_at(100.034));
  // The history of a stream faster than min_dt grows all the same.
  std::vector<double> fast;
  for (int i = 0; i < 40; ++i) {
    fast.push_back(0.001 * i);
  }
  EXPECT_GE(record(flight, fast).size(), 7U);
}

TEST(PoseHistory, KeepsNanosecondsAndABoundedNumber) {
  PoseHistory history;
  for (int i = 0; i < 1000; ++i) {
    history.add(Stamp(std::chrono::seconds(1700000000 + i) + std::chrono::nanoseconds(999)), RigidTransform(), kMinDt);
  }
  EXPECT_LE(history.size(), 128U);
  EXPECT_EQ(history.newest_stamp().time_since_epoch() % std::chrono::seconds(1), std::chrono::nanoseconds(999));
}

}  // namespace
}  // namespace rigidformer
