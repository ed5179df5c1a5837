// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/track_store.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "rigidformer/tracking/flying_blob.hpp"

namespace rigidformer {
namespace {

using testing::blob;
using testing::Flight;
using testing::observe;

constexpr double kTimeStep = 10.0 / 240.0;  // [s] ten frames of the training data

class TrackStoreTest : public ::testing::Test {
 protected:
  // Adds frames 0 .. count - 1 of a flight at 30 Hz from `start_s` on.
  void feed(const std::string& id, const Flight& flight, int count, double start_s = 100.0) {
    for (int i = 0; i < count; ++i) {
      store.add(observe(id, flight, start_s + i / 30.0, i / 30.0));
    }
  }

  TrackStore store{TrackingOptions()};
};

// The points of an object's state in world, whichever its reference frame is.
void expect_points(const Points& actual, const Points& expected) {
  ASSERT_EQ(actual.rows(), expected.rows());
  EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), 5e-6F);
}

TEST_F(TrackStoreTest, GivesBothStatesExactlyOneTimeStepApart) {
  const Flight flight;
  feed("a", flight, 5);
  const ObservedScene scene = store.snapshot(kTimeStep);
  ASSERT_EQ(scene.objects.size(), 1U);
  const ObjectState& state = scene.objects[0].state;
  EXPECT_NEAR(seconds_between({}, scene.stamp), 100.0 + 4 / 30.0, 1e-8);
  EXPECT_FALSE(scene.objects[0].assumed_static);
  EXPECT_FALSE(scene.objects[0].low_quality);
  expect_points(state.T_world_current.apply(state.points_reference), flight.pose(4 / 30.0).apply(blob()));
  expect_points(state.T_world_previous.apply(state.points_reference), flight.pose(4 / 30.0 - kTimeStep).apply(blob()));
}

TEST_F(TrackStoreTest, ReferenceIsTheFirstCloudAboutItsCentroid) {
  feed("a", Flight(), 3);
  const Points reference = store.snapshot(kTimeStep).objects[0].state.points_reference;
  EXPECT_LT(reference.colwise().mean().norm(), 1e-6F);
}

TEST_F(TrackStoreTest, P53_ObjectsOfAClockThatIsAheadAreForgottenWhenTheyStopComing) {
  ObjectObservation ahead = observe("ahead", Flight(), 104.0, 0.0);
  ahead.arrival = stamp_at(100.0);
  store.add(ahead);
  feed("b", Flight(), 60);
  const ObservedScene scene = store.snapshot(kTimeStep);
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.objects[0].state.id, "b");
  EXPECT_FALSE(scene.objects[0].assumed_static);
}

TEST_F(TrackStoreTest, P53_ObjectsOfDifferentClocksAreBothInTheScene) {
  for (int i = 0; i < 5; ++i) {
    for (const auto& [id, offset_s] : {std::pair<const char*, double>{"a", 2.0}, {"b", 0.0}}) {
      ObjectObservation observation = observe(id, Flight(), 100.0 + offset_s + i / 30.0, i / 30.0);
      observation.arrival = stamp_at(100.0 + i / 30.0);
      store.add(observation);
    }
  }
  const ObservedScene scene = store.snapshot(kTimeStep);
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_FALSE(scene.objects[0].low_quality);
  EXPECT_TRUE(scene.objects[1].low_quality);
  EXPECT_NE(scene.clock_remark.find("'b'"), std::string::npos) << scene.clock_remark;
}

TEST_F(TrackStoreTest, OneFrameIsAssumedStatic) {
  feed("a", Flight(), 1);
  const ObservedObject object = store.snapshot(kTimeStep).objects.at(0);
  EXPECT_TRUE(object.assumed_static);
  EXPECT_EQ(object.state.T_world_previous.translation, object.state.T_world_current.translation);
}

TEST_F(TrackStoreTest, TakesTheSceneWhereAllObjectsAre) {
  feed("a", Flight(), 4);
  feed("b", Flight(), 3);  // the newest cloud of "b" is still on the way
  const ObservedScene scene = store.snapshot(kTimeStep);
  EXPECT_NEAR(seconds_between({}, scene.stamp), 100.0 + 2 / 30.0, 1e-8);
  EXPECT_EQ(scene.objects.size(), 2U);
}

TEST_F(TrackStoreTest, ObjectsThatStayAwaySitOutAndAreForgotten) {
  feed("a", Flight(), 30);
  feed("b", Flight(), 10);
  const ObservedScene scene = store.snapshot(kTimeStep);
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.objects[0].state.id, "a");
  ASSERT_EQ(scene.skipped.size(), 1U);
  EXPECT_EQ(scene.skipped[0].id, "b");
  EXPECT_NE(scene.skipped[0].reason.find("not seen"), std::string::npos);
  feed("a", Flight(), 20, 101.0);
  EXPECT_TRUE(store.snapshot(kTimeStep).skipped.empty());
}

TEST_F(TrackStoreTest, StaticObjectsNeedOneCloud) {
  ObjectObservation table = observe("table", blob(), 90.0);
  table.mode = MotionMode::kStatic;
  store.add(table);
  EXPECT_NEAR(seconds_between({}, store.snapshot(kTimeStep).stamp), 90.0, 1e-9);
  feed("a", Flight(), 5);
  const ObservedScene scene = store.snapshot(kTimeStep);
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_NEAR(seconds_between({}, scene.stamp), 100.0 + 4 / 30.0, 1e-8);
  EXPECT_EQ(scene.objects[1].state.mode, MotionMode::kStatic);
  EXPECT_FALSE(scene.objects[1].assumed_static);
}

Points wire() {
  Points points = Points::Zero(20, 3);
  points.col(0).setLinSpaced(0.0F, 1.0F);
  return points;
}

TEST_F(TrackStoreTest, P36_WhatCannotBePredictedIsSkippedWithTheReason) {
  feed("a", Flight(), 5);
  store.add(observe("wire", wire(), 100.0));
  ObjectObservation feather = observe("feather", blob(), 100.0);
  feather.properties.mass_kg = 1e-9;
  store.add(feather);
  const ObservedScene scene = store.snapshot(kTimeStep);
  ASSERT_EQ(scene.objects.size(), 1U);
  ASSERT_EQ(scene.skipped.size(), 2U);
  for (const SkippedObject& skipped : scene.skipped) {
    EXPECT_EQ(skipped.cause, SkipCause::kUnusable);
    EXPECT_EQ(skipped.reason, *store.objection_to(skipped.id));
  }
  EXPECT_NE(scene.skipped[0].reason.find("mass_kg is 1e-09"), std::string::npos);
  EXPECT_NE(scene.skipped[1].reason.find("line"), std::string::npos);
  feather.properties.mass_kg = 1e-3;
  store.add(feather);
  EXPECT_FALSE(store.objection_to("feather")) << "what is known of it now is what counts";
}

TEST_F(TrackStoreTest, P37_WhatCannotBePredictedHasNoSayInTheTimeOfTheScene) {
  feed("a", Flight(), 5);
  const ObservedScene alone = store.snapshot(kTimeStep);
  for (const double stamp : {100.05, 100.0, 103.0}) {  // behind within the window, and by a clock that is ahead
    ObjectObservation observation = observe("wire", wire(), stamp);
    observation.arrival = stamp_at(100.15);
    store.add(observation);
    const ObservedScene scene = store.snapshot(kTimeStep);
    EXPECT_EQ(scene.stamp, alone.stamp) << stamp;
    ASSERT_EQ(scene.objects.size(), 1U) << stamp;
    EXPECT_EQ(scene.objects[0].state.T_world_current.translation, alone.objects[0].state.T_world_current.translation);
    EXPECT_EQ(scene.objects[0].state.T_world_previous.translation, alone.objects[0].state.T_world_previous.translation);
  }
}

TEST_F(TrackStoreTest, P37_AStaticObjectThatCannotBePredictedIsForgotten) {
  ObjectObservation table = observe("table", blob(), 100.0), rail = observe("rail", wire(), 100.0);
  table.mode = rail.mode = MotionMode::kStatic;
  store.add(table);
  store.add(rail);
  feed("a", Flight(), 10);
  EXPECT_EQ(store.snapshot(kTimeStep).skipped.size(), 1U);
  feed("a", Flight(), 30, 100.5);
  const ObservedScene scene = store.snapshot(kTimeStep);
  EXPECT_TRUE(scene.skipped.empty()) << "not reported for ever";
  EXPECT_EQ(scene.objects.size(), 2U) << "the table stays";
}

TEST_F(TrackStoreTest, LateCloudsAreDroppedAndRepeatedStampsReplace) {
  const Flight flight;
  feed("a", flight, 3);
  EXPECT_EQ(store.add(observe("a", flight, 100.02, 0.02)), AddResult::kLate);
  EXPECT_EQ(store.add(observe("a", flight, 100.0 + 2 / 30.0, 2 / 30.0)), AddResult::kExtended);
  const ObservedScene scene = store.snapshot(kTimeStep);
  EXPECT_FALSE(scene.objects[0].assumed_static);
  EXPECT_TRUE(scene.objects[0].state.T_world_previous.translation.allFinite());
}

TEST_F(TrackStoreTest, ALoopingClockStartsOver) {
  feed("a", Flight(), 30);
  feed("b", Flight(), 30);
  EXPECT_EQ(store.add(observe("a", Flight(), 100.0, 0.0)), AddResult::kTimeRestarted);
  ObservedScene scene = store.snapshot(kTimeStep);
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_NEAR(seconds_between({}, scene.stamp), 100.0, 1e-9);
  EXPECT_TRUE(scene.objects[0].assumed_static);
  feed("a", Flight(), 5, 100.1);
  EXPECT_FALSE(store.snapshot(kTimeStep).objects[0].assumed_static);
}

TEST_F(TrackStoreTest, GapsJumpsAndOtherPointsBeginANewTrack) {
  const Flight flight;
  feed("a", flight, 3);
  EXPECT_EQ(store.add(observe("a", flight, 110.0, 0.1)), AddResult::kNewTrackAfterGap) << "gap";
  Flight elsewhere;
  elsewhere.start.x() = 5.0;
  EXPECT_EQ(store.add(observe("a", elsewhere, 110.03, 0.1)), AddResult::kNewTrack) << "jump";
  EXPECT_EQ(store.add(observe("a", blob(31), 110.06)), AddResult::kNewTrack) << "count";
  EXPECT_TRUE(store.snapshot(kTimeStep).objects[0].assumed_static);
}

TEST_F(TrackStoreTest, SwappedIdsNeverBlend) {
  Flight left;
  Flight right;
  left.start.x() = -3.0;
  right.start.x() = 3.0;
  feed("left", left, 4);
  feed("right", right, 4);
  store.add(observe("left", right, 100.0 + 4 / 30.0, 4 / 30.0));
  store.add(observe("right", left, 100.0 + 4 / 30.0, 4 / 30.0));
  for (const ObservedObject& object : store.snapshot(kTimeStep).objects) {
    EXPECT_TRUE(object.assumed_static) << object.state.id;
  }
}

TEST_F(TrackStoreTest, ABadRigidFitIsLowQuality) {
  Flight still;
  still.gravity = 0.0;
  still.velocity.setZero();
  still.angular_velocity.setZero();
  store.add(observe("a", still, 100.0, 0.0));
  const Points noisy = still.pose(0.0).apply(blob()) + 0.3F * blob(30, 99);
  store.add(observe("a", noisy, 100.033));
  const ObservedObject object = store.snapshot(kTimeStep).objects.at(0);
  EXPECT_TRUE(object.low_quality);
  EXPECT_GT(object.quality.rmse_m, 0.02);
  EXPECT_LT(object.quality.inlier_ratio, 1.0);
}

TEST_F(TrackStoreTest, UnseenPointsDoNotBreakTheCorrespondence) {
  const Flight flight;
  Points first = flight.pose(0.0).apply(blob());
  Points second = flight.pose(0.033).apply(blob());
  first.row(3).setConstant(std::numeric_limits<float>::quiet_NaN());
  second.topRows(2).setConstant(std::numeric_limits<float>::quiet_NaN());
  store.add(observe("a", first, 100.0));
  EXPECT_EQ(store.add(observe("a", second, 100.033)), AddResult::kExtended);
  const ObjectState state = store.snapshot(0.033).objects.at(0).state;
  EXPECT_EQ(state.points_reference.rows(), 29);
  expect_points(state.T_world_current.apply(state.points_reference).bottomRows(26),
                flight.pose(0.033).apply(blob()).bottomRows(26));
}

TEST_F(TrackStoreTest, SmallAndDegenerateCloudsAreHarmless) {
  for (const int count : {0, 1, 2, 3}) {
    EXPECT_EQ(store.add(observe("a", blob(count), 100.0)), AddResult::kTooFewPoints);
  }
  Points all_nan = blob();
  all_nan.setConstant(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(store.add(observe("a", all_nan, 100.0)), AddResult::kTooFewPoints);
  EXPECT_TRUE(store.snapshot(kTimeStep).objects.empty());
  const Points same = Points::Ones(9, 3);
  Points line = blob();
  line.rightCols(2).setZero();
  for (const auto& [id, points] : {std::pair<std::string, Points>("same", same), {"line", line}}) {
    store.add(observe(id, points, 100.0));
    store.add(observe(id, points, 100.033));
  }
  for (const ObservedObject& object : store.snapshot(0.033).objects) {
    EXPECT_TRUE(is_valid(object.state.T_world_current)) << object.state.id;
  }
}

TEST_F(TrackStoreTest, GivenPosesReplaceRegistration) {
  const Flight flight;
  for (int i = 0; i < 3; ++i) {
    ObjectObservation seen = observe("a", flight, 100.0 + i / 30.0, i / 30.0);
    seen.T_world_object = flight.pose(i / 30.0);
    store.add(seen);
  }
  const ObjectState state = store.snapshot(kTimeStep).objects.at(0).state;
  expect_points(state.points_reference, blob());
  EXPECT_LT((state.T_world_previous.translation - flight.pose(2 / 30.0 - kTimeStep).translation).norm(), 1e-8);
}

}  // namespace
}  // namespace rigidformer
