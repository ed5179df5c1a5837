// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/health/timing_monitor.hpp"

#include <gtest/gtest.h>

namespace rigidformer_ros {
namespace {

// [s]. A forecast that takes longer is too slow. The tests take 0.1 to 0.4 s for a quick one and 1 s or more for a slow
// one.
constexpr double kLimit = 0.5;

const StageReport& of(const TimingReport& report, Stage stage) { return report.stages[static_cast<int>(stage)]; }

TEST(TimingMonitor, ReportsMeanAndMaximumSinceTheLastReport) {
  TimingMonitor monitor;
  monitor.add(Stage::kPreprocess, 0.1);
  monitor.add(Stage::kPreprocess, 0.3);
  const TimingReport report = monitor.take_report(1.0, kLimit);
  EXPECT_EQ(of(report, Stage::kPreprocess).runs, 2U);
  EXPECT_DOUBLE_EQ(of(report, Stage::kPreprocess).mean_s, 0.2);
  EXPECT_DOUBLE_EQ(of(report, Stage::kPreprocess).max_s, 0.3);
  EXPECT_EQ(of(report, Stage::kInference).runs, 0U);
  EXPECT_EQ(of(report, Stage::kInference).mean_s, 0.0);
  EXPECT_EQ(of(monitor.take_report(2.0, kLimit), Stage::kPreprocess).runs, 0U);
}

TEST(TimingMonitor, AForecastInTimeIsNotLate) {
  TimingMonitor monitor;
  EXPECT_EQ(monitor.take_report(9.0, kLimit).late_s, 0.0);
  monitor.begin_forecast(10.0);
  EXPECT_EQ(monitor.take_report(10.4, kLimit).late_s, 0.0);
  monitor.end_forecast(10.4, kLimit);
  const TimingReport report = monitor.take_report(99.0, kLimit);
  EXPECT_EQ(report.late_s, 0.0);
  EXPECT_NEAR(of(report, Stage::kForecast).max_s, 0.4, 1e-12);
}

TEST(TimingMonitor, SlowForecastsInARowAddUpUntilOneIsInTime) {
  TimingMonitor monitor;
  monitor.begin_forecast(10.0);
  monitor.end_forecast(11.0, kLimit);
  EXPECT_DOUBLE_EQ(monitor.take_report(50.0, kLimit).late_s, 1.0) << "nothing to do since: it does not grow";
  monitor.begin_forecast(11.5);
  monitor.end_forecast(13.0, kLimit);
  EXPECT_DOUBLE_EQ(monitor.take_report(13.0, kLimit).late_s, 3.0);
  monitor.begin_forecast(13.0);
  monitor.end_forecast(13.1, kLimit);
  EXPECT_EQ(monitor.take_report(13.1, kLimit).late_s, 0.0);
}

TEST(TimingMonitor, AForecastThatHangsIsLateWhileItHangs) {
  TimingMonitor monitor;
  monitor.begin_forecast(10.0);
  EXPECT_DOUBLE_EQ(monitor.take_report(14.0, kLimit).late_s, 4.0);
  EXPECT_DOUBLE_EQ(monitor.take_report(20.0, kLimit).late_s, 10.0);
}

}  // namespace
}  // namespace rigidformer_ros
