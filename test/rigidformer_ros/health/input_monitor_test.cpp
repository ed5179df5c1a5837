// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/health/input_monitor.hpp"

#include <gtest/gtest.h>

namespace rigidformer_ros {
namespace {

TEST(InputMonitor, CountsCloudsAndGapsPerTopic) {
  InputMonitor monitor;
  for (const std::uint32_t sequence : {10U, 11U, 15U}) {
    monitor.received("/a", sequence);
  }
  monitor.received("/b", 500);
  monitor.received("/b", 0);           // The publisher of /b restarted and counts from 0 again.
  monitor.received("/a", 2000000000);  // A second publisher of /a has a count of its own.
  const InputReport report = monitor.take_report(ros::Time(5.0), 1.0);
  EXPECT_EQ(report.received, 6U);
  EXPECT_EQ(report.lost, 3U);
  EXPECT_EQ(report.num_topics, 2U);
}

TEST(InputMonitor, SequenceNumbersMayWrapAround) {
  InputMonitor monitor;
  monitor.received("/a", 0xfffffffe);
  monitor.received("/a", 1);
  EXPECT_EQ(monitor.take_report(ros::Time(5.0), 1.0).lost, 2U);
}

TEST(InputMonitor, TheRateIsThatSinceThePreviousReport) {
  InputMonitor monitor;
  monitor.received("/a", 1);
  EXPECT_EQ(monitor.take_report(ros::Time(5.0), 10.0).rate_hz, 0.0) << "no time has passed yet";
  for (std::uint32_t i = 2; i < 32; ++i) {
    monitor.received("/a", i);
  }
  EXPECT_DOUBLE_EQ(monitor.take_report(ros::Time(5.0), 12.0).rate_hz, 15.0);
  EXPECT_EQ(monitor.take_report(ros::Time(5.0), 13.0).rate_hz, 0.0);
  EXPECT_EQ(monitor.take_report(ros::Time(5.0), 13.0).rate_hz, 0.0);
}

TEST(InputMonitor, CountsFramesAndForecasts) {
  InputMonitor monitor;
  // These are the stamps of clouds from two topics; before the last two clouds the clock restarts.
  for (const double stamp_s : {10.0, 10.0, 10.1, 10.0, 10.1, 10.2, 3.0, 3.0}) {
    monitor.used(ros::Time(stamp_s));
  }
  monitor.forecast_made();
  const InputReport report = monitor.take_report(ros::Time(3.1), 1.0);
  EXPECT_EQ(report.frames, 4U);
  EXPECT_EQ(report.forecast, 1U);
}

TEST(InputMonitor, TheAgeIsThatOfTheNewestUsableCloud) {
  InputMonitor monitor;
  monitor.received("/a", 1);
  EXPECT_FALSE(monitor.take_report(ros::Time(100.0), 1.0).age_s);
  monitor.used(ros::Time(99.5));
  monitor.scene_seen(3, 1);
  const InputReport report = monitor.take_report(ros::Time(100.0), 2.0);
  EXPECT_DOUBLE_EQ(*report.age_s, 0.5);
  EXPECT_EQ(report.num_objects, 3U);
  EXPECT_EQ(report.num_skipped, 1U);
  EXPECT_DOUBLE_EQ(*monitor.take_report(ros::Time(90.0), 3.0).age_s, -9.5) << "the clock jumped back";
}

}  // namespace
}  // namespace rigidformer_ros
