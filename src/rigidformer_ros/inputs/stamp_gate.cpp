// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/stamp_gate.hpp"

#include <algorithm>
#include <cstdio>

namespace rigidformer_ros {

namespace {

// [s] 2001. Smaller stamps count from the start of a device, a simulation or a bag.
constexpr double kFirstWallClock = 1e9;
// [s] Clocks that nobody sets differ by less, recordings by more. Chosen by eye.
constexpr double kLargestDrift = 3600.0;

const char* likely_cause_under_simulated_time(double ahead_s) {
  if (ahead_s > kLargestDrift) {
    return "wall-clock stamps under simulated time";
  }
  return ahead_s > 0.0 ? "a leftover from before a clock restart" : "old data; rosbag play needs --clock";
}

// Tells what to look at first. The difference alone cannot tell a recording from a wrong clock, but its size mostly
// can.
const char* likely_cause(const ros::Time& stamp, const ros::Time& now) {
  const double ahead_s = (stamp - now).toSec();
  if (now.toSec() < kFirstWallClock) {
    return likely_cause_under_simulated_time(ahead_s);
  }
  if (stamp.toSec() < kFirstWallClock) {
    return "the sensor stamps by a clock of its own, which counts from its start; its driver must stamp by ROS time";
  }
  if (ahead_s > -kLargestDrift) {
    return "the clocks of sensor and node differ, or the cloud took that long to come";
  }
  return "recorded data need use_sim_time and rosbag play --clock; otherwise the sensor's clock is not set";
}

}  // namespace

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
  char text[300];
  std::snprintf(text, sizeof(text), "stamp %.3f s lies %.3f s %s the clock %.3f s, %s is %.3g s: %s", stamp.toSec(),
                ahead > 0 ? ahead : -ahead, ahead > 0 ? "ahead of" : "behind", now.toSec(),
                future_limit < max_stamp_skew_s_ && ahead > 0 ? "history/jump_threshold" : "max_stamp_skew",
                ahead > 0 ? future_limit : max_stamp_skew_s_, likely_cause(stamp, now));
  return std::string(text);
}

}  // namespace rigidformer_ros
