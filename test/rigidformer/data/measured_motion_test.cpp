// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/data/measured_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "example_archive.hpp"

namespace rigidformer {
namespace {

/// Falls to the floor at t = 0.505 s with 2 m/s and jumps up with 1 m/s.
RigidTransform bouncing(double t) {
  const double since = t - 0.505;
  return {rotation_about({0.0, 0.0, 3.0 * t}), {0.5 * t, 0.0, since < 0.0 ? -2.0 * since : since}};
}

MeasuredTrack track(const std::string& id, const std::vector<double>& times_s) {
  MeasuredTrack track{id, times_s, {}};
  for (const double t : times_s) track.T_world_object.push_back(bouncing(t));
  return track;
}

std::vector<double> times(int count, double step_s, double begin_s = 0.0) {
  std::vector<double> times_s;
  for (int i = 0; i < count; ++i) times_s.push_back(begin_s + i * step_s);
  return times_s;
}

std::string refusal(const MeasuredRecording& recording, const FrameOptions& options) {
  return error_of([&] { to_frames(recording, options); });
}

TEST(ToFrames, WhatWasMeasuredInEqualStepsStaysUntouched) {
  MeasuredRecording recording{"7", {track("cup", times(101, 0.01)), track("box", times(101, 0.01))}};
  for (std::size_t i = 0; i < 101; ++i) {
    recording.tracks[0].times_s[i] += 0.0004 * std::sin(2.0 * static_cast<double>(i));  // jitter
  }
  for (const double asked_hz : {0.0, 100.0}) {
    const auto parts = to_frames(recording, {asked_hz, 2.5});
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_FALSE(parts[0].is_resampled);
    EXPECT_NEAR(parts[0].frame_rate_hz, 100.0, 0.1);
    EXPECT_EQ(parts[0].ids, (std::vector<std::string>{"cup", "box"}));
    for (std::size_t i = 0; i < 101; ++i) {
      EXPECT_EQ(parts[0].T_world_object[0][i].translation, recording.tracks[0].T_world_object[i].translation);
    }
  }
}

TEST(ToFrames, ResamplingKeepsAnImpactInsideItsInterval) {
  const MeasuredRecording recording{"7", {track("cup", times(1001, 0.001))}};
  const auto parts = to_frames(recording, {240.0, 2.5});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(parts[0].is_resampled);
  EXPECT_EQ(parts[0].frame_rate_hz, 240.0);
  ASSERT_EQ(parts[0].T_world_object[0].size(), 241U);
  for (int frame = 0; frame < 241; ++frame) {
    const double t = frame / 240.0;
    const RigidTransform &made = parts[0].T_world_object[0][static_cast<std::size_t>(frame)], truth = bouncing(t);
    // A frame is off only where the impact lies between the two measured poses around it.
    const bool around_impact = std::abs(t - 0.505) < 0.001;
    EXPECT_NEAR((made.translation - truth.translation).norm(), 0.0, around_impact ? 0.002 : 1e-9) << t;
    EXPECT_LT(rotation_angle(made.rotation, truth.rotation), 1e-6);
  }
}

TEST(ToFrames, ObjectsMeasuredAtOtherTimesMeetInCommonFrames) {
  const MeasuredRecording recording{"7", {track("cup", times(50, 0.01)), track("box", times(50, 0.01, 0.104))}};
  const auto parts = to_frames(recording, {});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(parts[0].is_resampled);
  ASSERT_EQ(parts[0].T_world_object[0].size(), 39U);  // from 0.104 to 0.49 s
  for (std::size_t i = 0; i < 39; ++i) {
    EXPECT_NEAR(parts[0].T_world_object[0][i].translation.x(), 0.5 * (0.104 + 0.01 * i), 1e-9);
    EXPECT_NEAR(parts[0].T_world_object[1][i].translation.x(), 0.5 * (0.104 + 0.01 * i), 1e-9);
  }
}

TEST(ToFrames, AGapPartsARecording) {
  std::vector<double> times_s = times(30, 0.01);
  const std::vector<double> later = times(20, 0.01, 0.5), last = times(2, 0.01, 0.9);
  times_s.insert(times_s.end(), later.begin(), later.end());
  times_s.insert(times_s.end(), last.begin(), last.end());
  const auto parts = to_frames({"7", {track("cup", times_s)}}, {});
  ASSERT_EQ(parts.size(), 2U);  // two poses at the end are no motion
  EXPECT_EQ(parts[0].name, "7");
  EXPECT_EQ(parts[1].name, "7_2");
  EXPECT_EQ(parts[0].T_world_object[0].size() + parts[1].T_world_object[0].size(), 50U);
}

TEST(ToFrames, RefusesToInventFrames) {
  const MeasuredRecording recording{"7", {track("cup", times(30, 0.02))}};
  EXPECT_NE(refusal(recording, {240.0, 2.5}).find("recording '7': frames of 240.0"), std::string::npos);
  EXPECT_NE(refusal({"7", {track("cup", {0.0})}}, {}).find("'cup' has one pose only"), std::string::npos);
  EXPECT_NE(refusal({"7", {track("cup", {0.0, 0.1})}}, {}).find("fewer than three"), std::string::npos);
}

}  // namespace
}  // namespace rigidformer
