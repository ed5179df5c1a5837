// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/health/input_monitor.hpp"

namespace rigidformer_ros {

namespace {

// [clouds]; chosen by eye. A larger gap in the sequence means a restarted or a second publisher, not lost clouds.
constexpr std::uint32_t kLargestGap = 1000;
// [s]; chosen by eye. A stamp that is further behind the newest frame comes from a clock that jumped back.
constexpr double kLargestDelay = 1.0;

}  // namespace

void InputMonitor::received(const std::string& topic, std::uint32_t sequence) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++report_.received;
  const auto [last, is_new] = last_sequence_.try_emplace(topic, sequence);
  const std::uint32_t gap = sequence - last->second - 1;  // Unsigned: it wraps around where the sequence number does.
  if (!is_new && gap <= kLargestGap) {
    report_.lost += gap;
  }
  last->second = sequence;
}

void InputMonitor::used(const ros::Time& stamp) {
  const std::lock_guard<std::mutex> lock(mutex_);
  newest_stamp_ = stamp;
  if (stamp > last_frame_ || (last_frame_ - stamp).toSec() > kLargestDelay) {
    ++report_.frames;
    last_frame_ = stamp;
  }
}

void InputMonitor::forecast_made() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++report_.forecast;
}

void InputMonitor::scene_seen(std::size_t num_objects, std::size_t num_skipped) {
  const std::lock_guard<std::mutex> lock(mutex_);
  report_.num_objects = num_objects;
  report_.num_skipped = num_skipped;
}

InputReport InputMonitor::take_report(const ros::Time& now, double steady_s) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double elapsed_s = steady_s - reported_at_s_.value_or(steady_s);
  report_.num_topics = last_sequence_.size();
  report_.rate_hz = elapsed_s > 0.0 ? static_cast<double>(report_.received - received_before_) / elapsed_s : 0.0;
  report_.age_s.reset();
  if (newest_stamp_) {
    report_.age_s = (now - *newest_stamp_).toSec();
  }
  received_before_ = report_.received;
  reported_at_s_ = steady_s;
  return report_;
}

}  // namespace rigidformer_ros
