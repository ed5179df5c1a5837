// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/scene_instant.hpp"

#include <gtest/gtest.h>

namespace rigidformer {
namespace {

constexpr double kWindow = 0.1;

Sighting seen(const std::string& id, double stamp_s, double arrival_s) {
  return {id, stamp_at(stamp_s), stamp_at(arrival_s)};
}

TEST(SceneInstantTest, IsWhereTheSlowestObjectIs) {
  const SceneInstant instant = choose_instant({seen("a", 10.0, 10.01), seen("b", 9.95, 10.0)}, kWindow);
  EXPECT_EQ(instant.stamp, stamp_at(9.95));
  EXPECT_EQ(instant.presence, (std::vector<Presence>{Presence::kShared, Presence::kShared}));
  EXPECT_EQ(instant.clock_remark, "");
}

TEST(SceneInstantTest, AnObjectThatNoLongerComesIsUnseen) {
  const SceneInstant instant = choose_instant({seen("a", 10.0, 10.0), seen("b", 9.5, 9.5)}, kWindow);
  EXPECT_EQ(instant.stamp, stamp_at(10.0));
  EXPECT_EQ(instant.presence, (std::vector<Presence>{Presence::kShared, Presence::kUnseen}));
}

TEST(SceneInstantTest, P53_ClocksThatDifferStallNobody) {
  const SceneInstant instant =
      choose_instant({seen("a", 12.0, 10.0), seen("b", 10.0, 10.02), seen("c", 12.01, 10.01)}, kWindow);
  EXPECT_EQ(instant.stamp, stamp_at(12.0));
  EXPECT_EQ(instant.presence[1], Presence::kOwnClock);
  EXPECT_NE(instant.clock_remark.find("'b'"), std::string::npos) << instant.clock_remark;
  EXPECT_NE(instant.clock_remark.find("2.01 s before"), std::string::npos) << instant.clock_remark;
  EXPECT_NE(instant.clock_remark.find("input/sync_window"), std::string::npos) << instant.clock_remark;
}

TEST(SceneInstantTest, P53_AStampAheadDoesNotOutliveItsObject) {
  const SceneInstant instant = choose_instant({seen("ahead", 14.0, 9.0), seen("b", 10.0, 10.0)}, kWindow);
  EXPECT_EQ(instant.stamp, stamp_at(10.0));
  EXPECT_EQ(instant.presence, (std::vector<Presence>{Presence::kUnseen, Presence::kShared}));
}

TEST(SceneInstantTest, CloudsOfOneInstantThatTakeLongToRegisterBelongTogether) {
  const SceneInstant instant = choose_instant({seen("a", 10.0, 10.0), seen("b", 10.0, 10.4)}, kWindow);
  EXPECT_EQ(instant.presence, (std::vector<Presence>{Presence::kShared, Presence::kShared}));
}

}  // namespace
}  // namespace rigidformer
