// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <optional>
#include <string>

namespace rigidformer_ros {

/// Decides whether a stamp can belong to the present, and notices when the clock starts over.
class StampGate {
 public:
  StampGate(double max_stamp_skew_s, double jump_threshold_s)
      : max_stamp_skew_s_(max_stamp_skew_s), jump_threshold_s_(jump_threshold_s) {}

  /// True once for every backward jump of the clock beyond the threshold. Call it with the clock before using it.
  bool clock_restarted(const ros::Time& now);

  /// Why `stamp` is not usable at `now`, naming the likely cause; empty when it is. After a restart of the clock,
  /// stamps from its future are leftovers of the time before and refused beyond the jump threshold.
  std::optional<std::string> objection(const ros::Time& stamp, const ros::Time& now) const;

 private:
  double max_stamp_skew_s_;
  double jump_threshold_s_;
  ros::Time last_now_;
  bool has_restarted_ = false;
};

}  // namespace rigidformer_ros
