// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

namespace rigidformer_ros::demo {

/// The time of a played scene: either the time of ROS, or a simulated one that this clock publishes on /clock.
class SceneClock {
 public:
  /// With `publish`, the clock is simulated and advances `time_scale` seconds per second of wall time. Throws
  /// std::invalid_argument for a scale that is not positive.
  SceneClock(ros::NodeHandle& node, bool publish, double time_scale);

  ros::Time now() const;

  /// Returns at `time`, or when ROS shuts down.
  void sleep_until(const ros::Time& time);

  /// Lets `seconds` of wall time pass. A simulated clock stands still meanwhile, but goes on being published.
  void hold(double seconds);

 private:
  void publish();

  bool publish_;
  double time_scale_;
  ros::Time simulated_{1.0};  // The first time must not be 0, which would mean "no clock yet".
  ros::Publisher publisher_;
};

}  // namespace rigidformer_ros::demo
