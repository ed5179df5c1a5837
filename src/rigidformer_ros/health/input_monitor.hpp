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

/// What arrived at the node and what became of it. Counts are those since the start of the node.
struct InputReport {
  std::size_t num_topics = 0;   ///< Topics that delivered a cloud
  std::uint64_t received = 0;   ///< Clouds received
  std::uint64_t lost = 0;       ///< Clouds that were overwritten in a queue before the node saw them
  std::uint64_t frames = 0;     ///< Moments of which a usable cloud came
  std::uint64_t forecast = 0;   ///< Frames that were forecast; the other frames came while a forecast was being made
  double rate_hz = 0.0;         ///< Clouds of all topics per second since the previous report
  std::optional<double> age_s;  ///< Age of the newest usable cloud [s]; empty before the first one
  std::size_t num_objects = 0;  ///< Objects in the newest scene
  std::size_t num_skipped = 0;  ///< Known objects that took no part in the newest scene
};

/// Counts the clouds that arrive. All functions may be called from any thread.
class InputMonitor {
 public:
  /// Counts a cloud that was handed to the node. `sequence` is header.seq, which a publisher counts up from cloud to
  /// cloud, so that a gap means clouds that were lost on the way. One publisher per topic is assumed.
  void received(const std::string& topic, std::uint32_t sequence);

  /// Counts the frame of a cloud that became an observation. Clouds of the same stamp are one frame.
  void used(const ros::Time& stamp);

  /// Counts a forecast of the newest scene.
  void forecast_made();

  /// Remembers the numbers of objects of the newest scene.
  void scene_seen(std::size_t num_objects, std::size_t num_skipped);

  /// Makes a report. `now` is the time of the clock that the stamps come from, `steady_s` that of one that never jumps.
  InputReport take_report(const ros::Time& now, double steady_s);

 private:
  std::mutex mutex_;
  InputReport report_;
  std::map<std::string, std::uint32_t> last_sequence_;  ///< The newest sequence number of each topic
  std::optional<ros::Time> newest_stamp_;
  ros::Time last_frame_;
  std::uint64_t received_before_ = 0;
  std::optional<double> reported_at_s_;
};

}  // namespace rigidformer_ros
