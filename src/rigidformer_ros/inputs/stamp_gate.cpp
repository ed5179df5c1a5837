// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/stamp_gate.hpp"

#include <algorithm>
#include <cstdio>

namespace rigidformer_ros {

bool StampGate::clock_restarted(const ros::Time& now) {
  const bool restarted = (now - last_now_).toSec() < -jump_threshold_s_;
  has_restarted_ = has_restarted_ || restarted;
  last_now_ = now;
  return restarted;
}

std::optional<std::string> StampGate::objection(const ros::Time& stamp, const ros::Time& now) const {
  if (now.isZero()) {
    return "the clock has not started (use_sim_time is set, but nothing publishes /clock)";
  }
  if (stamp.isZero()) {
    return "stamp is 0 (the publisher does not fill header.stamp)";
  }
  const double ahead = (stamp - now).toSec();
  const double future_limit = has_restarted_ ? std::min(jump_threshold_s_, max_stamp_skew_s_) : max_stamp_skew_s_;
  if (ahead <= future_limit && ahead >= -max_stamp_skew_s_) {
    return std::nullopt;
  }
  char text[200];
  std::snprintf(text, sizeof(text), "stamp %.3f s lies %.3f s %s the clock %.3f s (%s)", stamp.toSec(),
                ahead > 0 ? ahead : -ahead, ahead > 0 ? "ahead of" : "behind", now.toSec(),
                ahead > 0 ? "wall-clock stamps under simulated time, or a leftover from before a clock restart"
                          : "old data: playing a bag needs use_sim_time and --clock");
  return std::string(text);
}

}  // namespace rigidformer_ros
