// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/health/timing_monitor.hpp"

#include <algorithm>
#include <chrono>

namespace rigidformer_ros {

void TimingMonitor::add(Stage stage, double seconds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  StageReport& sum = sums_[static_cast<std::size_t>(stage)];
  ++sum.runs;
  sum.mean_s += seconds;
  sum.max_s = std::max(sum.max_s, seconds);
}

void TimingMonitor::begin_forecast(double now_s) {
  const std::lock_guard<std::mutex> lock(mutex_);
  forecast_since_s_ = now_s;
}

void TimingMonitor::end_forecast(double now_s, double max_processing_time_s) {
  double seconds = 0.0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const double since_s = forecast_since_s_.value_or(now_s);
    seconds = now_s - since_s;
    if (seconds > max_processing_time_s) {
      slow_since_s_ = slow_since_s_.value_or(since_s);
      slow_until_s_ = now_s;
    } else {
      slow_since_s_.reset();
    }
    forecast_since_s_.reset();
  }
  add(Stage::kForecast, seconds);
}

TimingReport TimingMonitor::take_report(double now_s, double max_processing_time_s) {
  const std::lock_guard<std::mutex> lock(mutex_);
  TimingReport report;
  report.stages = sums_;
  for (StageReport& stage : report.stages) {
    stage.mean_s /= static_cast<double>(std::max<std::uint64_t>(1, stage.runs));
  }
  report.late_s = late_s(now_s, max_processing_time_s);
  sums_ = {};
  return report;
}

double TimingMonitor::late_s(double now_s, double max_processing_time_s) const {
  if (forecast_since_s_ && now_s - *forecast_since_s_ > max_processing_time_s) {
    return now_s - slow_since_s_.value_or(*forecast_since_s_);
  }
  return slow_since_s_ ? slow_until_s_ - *slow_since_s_ : 0.0;
}

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ForecastTimer::ForecastTimer(TimingMonitor& monitor, double max_processing_time_s)
    : monitor_(monitor), max_processing_time_s_(max_processing_time_s) {
  monitor_.begin_forecast(steady_seconds());
}

ForecastTimer::~ForecastTimer() { monitor_.end_forecast(steady_seconds(), max_processing_time_s_); }

}  // namespace rigidformer_ros
