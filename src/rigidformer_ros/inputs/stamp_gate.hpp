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

  /// Tells whether the clock has jumped back by more than the threshold since the last call. Callers must report every
  /// new time of the clock here before they ask for an objection at that time.
  bool clock_restarted(const ros::Time& now);

  /// Says why `stamp` is not usable at `now` and names the likely cause. The result is empty when the stamp is usable.
  /// Once the clock has restarted, a stamp ahead of it by more than the jump threshold is refused as a leftover from
  /// the time before.
  std::optional<std::string> objection(const ros::Time& stamp, const ros::Time& now) const;

 private:
  double max_stamp_skew_s_;
  double jump_threshold_s_;
  ros::Time last_now_;
  bool has_restarted_ = false;
};

}  // namespace rigidformer_ros
