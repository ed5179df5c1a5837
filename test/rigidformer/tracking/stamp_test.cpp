// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/stamp.hpp"

#include <gtest/gtest.h>

namespace rigidformer {
namespace {

TEST(StampTest, KeepsNanosecondsOfTheYearsToCome) {
  const Stamp now = Stamp(std::chrono::seconds(1800000000) + std::chrono::nanoseconds(123456789));
  EXPECT_EQ(seconds_between(now, now + std::chrono::nanoseconds(1)), 1e-9);
  EXPECT_EQ(seconds_between(now + std::chrono::nanoseconds(1), now), -1.0 + 1e-9 * 999999999);
}

TEST(StampTest, RoundsSecondsToTheNearestNanosecond) {
  EXPECT_EQ(to_duration(0.1).count(), 100000000);
  EXPECT_EQ(to_duration(-0.25).count(), -250000000);
  EXPECT_EQ(to_duration(1e-10).count(), 0);
  EXPECT_EQ(stamp_at(100.5) - stamp_at(100.0), std::chrono::milliseconds(500));
}

TEST(StampTest, TheZeroOfTheClockIsTheDefault) { EXPECT_EQ(stamp_at(0.0), Stamp()); }

}  // namespace
}  // namespace rigidformer
