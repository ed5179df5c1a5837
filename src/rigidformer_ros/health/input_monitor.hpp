// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace rigidformer_ros {

struct InputReport {
  std::size_t num_topics = 0;   ///< That delivered a cloud since the start
  std::uint64_t received = 0;   ///< Clouds since the start
  std::uint64_t lost = 0;       ///< Clouds since the start that were overwritten in a queue before the node saw them
  std::uint64_t frames = 0;     ///< Moments since the start of which there is a usable cloud
  std::uint64_t forecast = 0;   ///< Of them, whose scene was forecast; the others came while one was being made
  double rate_hz = 0.0;         ///< Clouds of all topics, since the previous report
  std::optional<double> age_s;  ///< Of the newest usable cloud; empty before the first
  std::size_t num_objects = 0;  ///< In the newest scene
  std::size_t num_skipped = 0;  ///< Known objects that took no part in it
};

/// Counts what arrives. Safe to call from any thread.
class InputMonitor {
 public:
  /// A cloud was handed to the node. `sequence` is header.seq, which a publisher counts up from cloud to cloud: gaps
  /// are clouds that were lost on the way. One publisher per topic is assumed.
  void received(const std::string& topic, std::uint32_t sequence);

  /// A cloud with this stamp became an observation.
  void used(const ros::Time& stamp);

  /// A forecast of the newest scene was made.
  void forecast_made();

  void scene_seen(std::size_t num_objects, std::size_t num_skipped);

  /// `now` is the clock of the stamps, `steady_s` one that never jumps.
  InputReport take_report(const ros::Time& now, double steady_s);

 private:
  std::mutex mutex_;
  InputReport report_;
  std::map<std::string, std::uint32_t> last_sequence_;  ///< By topic
  std::optional<ros::Time> newest_stamp_;
  ros::Time last_frame_;
  std::uint64_t received_before_ = 0;
  std::optional<double> reported_at_s_;
};

}  // namespace rigidformer_ros
