// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/live_scene.hpp"

#include <gtest/gtest.h>

#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

class LiveSceneTest : public ::testing::Test {
 protected:
  // Gives the scene the cloud of the flight at time `t`, which arrives when the clock shows `now`. Both are in seconds;
  // the flight begins at 100 s.
  bool add(double t, double now) {
    if (!scene.accepts("a", ros::Time(t), ros::Time(now))) {
      return false;
    }
    scene.add(testing::observe("a", testing::Flight(), t, t - 100.0));
    return true;
  }

  std::uint64_t rejected(const std::string& reason) {
    const auto counts = rejections.counts();
    return counts.count(reason) > 0 ? counts.at(reason).total : 0;
  }

  RejectionLog rejections;
  LiveScene scene{NodeParameters(), rejections};
};

TEST_F(LiveSceneTest, P08_jitter_of_the_stamps_drops_single_clouds_only) {
  double now = 100.0;
  for (const double t : {100.0, 100.033, 100.066, 100.045, 100.1, 100.0999, 100.133}) {
    now = std::max(now, t);
    EXPECT_TRUE(add(t, now));
  }
  EXPECT_EQ(rejected("late cloud"), 2U);
  EXPECT_EQ(scene.epoch(), 0U) << "nothing was forgotten";
  const ObservedScene observed = scene.snapshot(0.04);
  EXPECT_EQ(observed.stamp, rigidformer::stamp_at(100.133));
  ASSERT_EQ(observed.objects.size(), 1U);
  EXPECT_FALSE(observed.objects[0].assumed_static);
  EXPECT_LT((observed.objects[0].state.T_world_previous.translation - testing::Flight().pose(0.093).translation).norm(),
            1e-4);
}

TEST_F(LiveSceneTest, P07_a_clock_that_starts_over_begins_a_new_epoch) {
  add(100.0, 100.0);
  add(100.033, 100.033);
  const std::uint64_t track = scene.records().at("a").track;
  scene.watch_clock(ros::Time(90.0));
  EXPECT_EQ(scene.epoch(), 1U);
  EXPECT_TRUE(scene.records().empty());
  EXPECT_FALSE(add(100.066, 90.01)) << "a leftover from before the jump";
  EXPECT_EQ(rejected("bad stamp"), 1U);
  EXPECT_TRUE(add(90.033, 90.033));
  EXPECT_NE(scene.records().at("a").track, track);
  EXPECT_EQ(scene.epoch(), 1U);
  scene.reset();
  EXPECT_EQ(scene.epoch(), 2U);
}

TEST_F(LiveSceneTest, P57_slow_clouds_are_noted_with_the_gap_and_the_limit) {
  add(100.0, 100.0);
  add(100.5, 100.5);
  const auto counts = rejections.counts();
  ASSERT_EQ(counts.count("gap between clouds"), 1U);
  const RejectionLog::Count& gap = counts.at("gap between clouds");
  EXPECT_FALSE(gap.was_rejected);
  EXPECT_NE(gap.detail.find("0.5 s apart"), std::string::npos) << gap.detail;
  EXPECT_NE(gap.detail.find("history/max_dt is 0.3 s"), std::string::npos) << gap.detail;
  EXPECT_EQ(rejections.take_report().at(0).find("Noticed, "), 0U);
}

TEST_F(LiveSceneTest, P57_late_clouds_feed_the_scene_as_long_as_they_come) {
  rigidformer::ObjectObservation late = testing::observe("a", testing::Flight(), 100.0, 0.0);
  late.arrival = rigidformer::stamp_at(103.0);
  scene.add(late);
  EXPECT_TRUE(scene.is_fed(rigidformer::stamp_at(103.5), 1.0));
  EXPECT_FALSE(scene.is_fed(rigidformer::stamp_at(104.5), 1.0));
}

TEST_F(LiveSceneTest, RecordsHoldThePosesOfEveryTrack) {
  add(100.0, 100.0);
  add(100.033, 100.033);
  const rigidformer::TrackRecord record = scene.records().at("a");
  EXPECT_EQ(record.track, scene.snapshot(0.04).objects.at(0).track);
  EXPECT_EQ(record.poses.size(), 2U);
  EXPECT_EQ(record.poses.newest_stamp(), rigidformer::stamp_at(100.033));
  EXPECT_FALSE(record.low_quality);
}

TEST_F(LiveSceneTest, P38_every_cloud_of_an_object_that_cannot_be_predicted_is_counted_once) {
  Points wire = Points::Zero(20, 3);
  wire.col(0).setLinSpaced(0.0F, 1.0F);
  for (int i = 0; i < 5; ++i) {
    add(100.0 + i / 30.0, 100.2);
    scene.add(testing::observe("wire", wire, 100.0 + i / 30.0));
  }
  scene.add(testing::observe("wire", wire, 100.0));  // late: counted as that
  EXPECT_EQ(rejected(kUnusableObject), 5U);
  EXPECT_EQ(rejected("late cloud"), 1U);
  EXPECT_NE(rejections.counts().at(kUnusableObject).detail.find("'wire': its points lie on a line"), std::string::npos);
  const ObservedScene observed = scene.snapshot(0.04);
  ASSERT_EQ(observed.objects.size(), 1U);
  ASSERT_EQ(observed.skipped.size(), 1U);
  EXPECT_EQ(observed.skipped[0].id, "wire");
}

}  // namespace
}  // namespace rigidformer_ros
