// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/playback/scene_clock.hpp"

#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <stdexcept>

namespace rigidformer_ros::demo {
namespace {
// [s] of simulated time between two messages on /clock; chosen by eye, shorter than the time between two clouds.
constexpr double kTick = 1.0 / 120.0;
}  // namespace

SceneClock::SceneClock(ros::NodeHandle& node, bool publish, double time_scale)
    : publish_(publish), time_scale_(time_scale) {
  if (!(time_scale > 0.0)) {
    throw std::invalid_argument("time_scale must be positive, got " + std::to_string(time_scale));
  }
  if (publish_) {
    publisher_ = node.advertise<rosgraph_msgs::Clock>("/clock", 10);
  }
}

ros::Time SceneClock::now() const { return publish_ ? simulated_ : ros::Time::now(); }

void SceneClock::sleep_until(const ros::Time& time) {
  if (!publish_) {
    ros::Time::sleepUntil(time);
    return;
  }
  // Every tick sleeps until a time counted from the start: sleeps that are a little too long must not add up.
  const ros::WallTime wall_start = ros::WallTime::now();
  const ros::Time start = simulated_;
  while (ros::ok() && simulated_ < time) {
    simulated_ = std::min(time, simulated_ + ros::Duration(kTick));
    ros::WallTime::sleepUntil(wall_start + ros::WallDuration((simulated_ - start).toSec() / time_scale_));
    publish();
  }
}

void SceneClock::hold(double seconds) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (ros::ok() && ros::WallTime::now() < end) {
    publish();
    ros::WallDuration(0.05).sleep();
  }
}

void SceneClock::publish() {
  if (publish_) {
    rosgraph_msgs::Clock message;
    message.clock = simulated_;
    publisher_.publish(message);
  }
}

}  // namespace rigidformer_ros::demo
