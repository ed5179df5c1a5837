// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/outputs/candidate_display.hpp"

#include <gtest/gtest.h>

namespace rigidformer_ros {
namespace {

TEST(CandidateDisplay, APathWherePosesWereRecordedElseADotAndALinePerTrack) {
  BatchRequest request;
  request.candidates.resize(2);
  request.candidates[1].kinematic.resize(1);
  request.candidates[1].kinematic[0].poses.resize(3);
  BatchResult result;
  result.header.frame_id = "world";
  result.results.resize(2);
  result.results[0].objects.resize(1);
  result.results[0].objects[0].poses.resize(4);
  result.results[1].objects.resize(1);
  result.results[1].stop_reason = CandidateResult::STOP_CONDITION;
  const auto markers = candidate_markers(request, result, {}).markers;
  ASSERT_EQ(markers.size(), 4u);
  EXPECT_EQ(markers[0].action, visualization_msgs::Marker::DELETEALL) << "those of the request before go";
  EXPECT_EQ(markers[1].points.size(), 4u);
  EXPECT_EQ(markers[2].type, visualization_msgs::Marker::SPHERE);
  EXPECT_NE(markers[1].color.r, markers[2].color.r);
  EXPECT_EQ(markers[3].points.size(), 3u);
  request.scene.header.frame_id = "camera";
  EXPECT_EQ(candidate_markers(request, result, {}).markers.size(), 3u) << "tracks in another frame are not drawn";
}

}  // namespace
}  // namespace rigidformer_ros
