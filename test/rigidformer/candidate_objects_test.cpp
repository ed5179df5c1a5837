// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/candidate_objects.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rigidformer/box_scene.hpp"

namespace rigidformer {
namespace {

const double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kSceneStep_s = 0.04;  // [s]

std::vector<CandidateObject> resolved(const Candidate& candidate) {
  return candidate_objects(candidate, {box("a", {0, 0, 0.5}), box("b", {3, 0, 0.5})}, kSceneStep_s);
}

void expect_refused(const Candidate& candidate, CandidateOutcome::Error kind, const std::string& word) {
  try {
    resolved(candidate);
    ADD_FAILURE() << "accepted, although: " << word;
  } catch (const CandidateError& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what() << " lacks " << word;
  }
}

GivenTrack track_to(const std::string& id, double x, double seconds) {
  return {id, {}, {}, {0.0, seconds}, {at(0, 0, 2), at(x, 0, 2)}, 0.0};
}

TEST(CandidateObjects, AnEmptyCandidateIsTheScene) {
  const auto objects = resolved({});
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[1].state.id, "b");
  EXPECT_EQ(objects[1].source, 1);
  EXPECT_FALSE(objects[1].is_placed);
}

TEST(CandidateObjects, RemovalComesFirstThenChangesThenTracks) {
  Candidate candidate;
  candidate.removed_ids = {"a"};
  candidate.tracks = {track_to("a", 1.0, 1.0)};
  candidate.tracks[0].points_reference = box_cloud(0.2);
  const auto objects = resolved(candidate);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].state.id, "b");
  EXPECT_EQ(objects[1].state.id, "a");
  EXPECT_EQ(objects[1].source, -1) << "a body of its own in the place of the removed one";

  candidate = {};
  candidate.changes = {{"a", at(7, 0, 1), Twist(), MotionMode::kDynamic}};
  candidate.tracks = {track_to("a", 1.0, 1.0)};
  const CandidateObject driven = resolved(candidate)[0];
  EXPECT_EQ(driven.state.mode, MotionMode::kKinematic);
  EXPECT_EQ(driven.state.T_world_current.translation.z(), 2.0);
  EXPECT_FALSE(driven.twist);
}

TEST(CandidateObjects, APoseKeepsTheObservedMotion) {
  ObjectState moving = box("a", {0, 0, 0.5});
  moving.T_world_previous.translation.x() = -0.02;
  Candidate candidate;
  candidate.changes = {{"a", at(5, 0, 1), {}, {}}};
  const auto objects = candidate_objects(candidate, {moving}, kSceneStep_s);
  EXPECT_NEAR(objects[0].state.T_world_previous.translation.x(), 4.98, 1e-12);
  EXPECT_TRUE(objects[0].is_placed);
  candidate.changes[0].mode = MotionMode::kStatic;
  EXPECT_EQ(candidate_objects(candidate, {moving}, kSceneStep_s)[0].state.T_world_previous.translation.x(), 5.0);
}

TEST(CandidateObjects, KnownPropertiesReplaceOthersStay) {
  Candidate candidate;
  candidate.changes = {{"a", {}, {}, {}, {{}, 0.1, {}}}};
  const BodyProperties properties = resolved(candidate)[0].state.properties;
  EXPECT_EQ(properties.friction, 0.1);
  EXPECT_EQ(properties.mass_kg, 1.0);
}

TEST(CandidateObjects, ATrackIsLinearBetweenItsPosesAndStaysOutside) {
  GivenTrack track = track_to("a", 1.0, 2.0);
  track.T_world_reference[1].rotation = rotation_about({0.0, 0.0, 1.0});
  EXPECT_EQ(pose_at(track, -1.0).translation.x(), 0.0);
  EXPECT_NEAR(pose_at(track, 0.5).translation.x(), 0.25, 1e-12);
  EXPECT_NEAR(rotation_vector(pose_at(track, 0.5).rotation).z(), 0.25, 1e-12);
  EXPECT_EQ(pose_at(track, 9.0).translation.x(), 1.0);
}

TEST(CandidateObjects, UnknownObjectsAreNamed) {
  constexpr auto kUnknown = CandidateOutcome::Error::kUnknownObject;
  Candidate candidate;
  candidate.removed_ids = {"x"};
  expect_refused(candidate, kUnknown, "'x'");
  candidate = {};
  candidate.changes = {{"x", {}, {}, {}}};
  expect_refused(candidate, kUnknown, "overrides 'x'");
  candidate = {};
  candidate.pushes = {{"x"}};
  expect_refused(candidate, kUnknown, "impulses 'x'");
  candidate = {};
  candidate.tracks = {track_to("x", 1.0, 1.0)};
  expect_refused(candidate, kUnknown, "kinematic 'x'");
  candidate = {};
  candidate.removed_ids = {"a", "a"};
  expect_refused(candidate, kUnknown, "'a'");
}

TEST(CandidateObjects, WhatIsNotPossibleIsNamed) {
  constexpr auto kInvalid = CandidateOutcome::Error::kInvalid;
  const auto change = [&](const StateChange& wanted, const std::string& word) {
    Candidate candidate;
    candidate.changes = {wanted};
    expect_refused(candidate, kInvalid, word);
  };
  change({"a", at(kNoNumber, 0, 0), {}, {}}, "pose");
  change({"a", {}, Twist{{kNoNumber, 0, 0}, {0, 0, 0}}, {}}, "twist");
  change({"a", {}, Twist(), MotionMode::kStatic}, "static");
  change({"a", {}, {}, {}, {-1.0, {}, {}}}, "mass_kg");
  const auto drive = [&](const std::function<void(GivenTrack&)>& spoil, const std::string& word) {
    Candidate candidate;
    candidate.tracks = {track_to("a", 1.0, 1.0)};
    spoil(candidate.tracks[0]);
    expect_refused(candidate, kInvalid, word);
  };
  drive([](GivenTrack& track) { track.times_s[1] = 0.0; }, "times[1]");
  drive([](GivenTrack& track) { track.times_s[1] = kNoNumber; }, "times[1]");
  drive([](GivenTrack& track) { track.times_s.pop_back(); }, "1 times and 2 poses");
  drive([](GivenTrack& track) { track.T_world_reference[1].translation.x() = kNoNumber; }, "poses[1]");
  drive([](GivenTrack& track) { track.max_speed_mps = 0.9; }, "max_speed");
  drive([](GivenTrack& track) { track.points_reference = box_cloud(0.2); }, "cloud");
  const auto push = [&](const Push& wanted, const std::string& word) {
    Candidate candidate;
    candidate.pushes = {wanted};
    candidate.changes = {{"b", {}, {}, MotionMode::kStatic}};
    expect_refused(candidate, kInvalid, word);
  };
  push({"a", -1.0}, "time");
  push({"a", 0.0, {kNoNumber, 0, 0}}, "finite");
  push({"b", 0.0, {1, 0, 0}}, "given");
  ObjectState unknown = box("a", {0, 0, 0.5});
  unknown.properties.mass_kg.reset();
  Candidate candidate;
  candidate.pushes = {{"a", 0.0, {1, 0, 0}}};
  EXPECT_THROW(candidate_objects(candidate, {unknown}, kSceneStep_s), CandidateError);
}

}  // namespace
}  // namespace rigidformer
