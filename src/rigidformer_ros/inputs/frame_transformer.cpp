// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/frame_transformer.hpp"

#include <tf2/exceptions.h>

#include <utility>

#include "rigidformer_ros/messages/conversions.hpp"

namespace rigidformer_ros {

namespace {

// [s] of wall time between two questions to tf; chosen by eye. The wait of tf itself would block with a stopped clock.
constexpr double kPollPeriod = 0.005;

// tf 1 wrote frames as /camera, tf 2 refuses them.
std::string without_slash(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

}  // namespace

FrameTransformer::FrameTransformer(std::string fixed_frame, double timeout_s, const ros::NodeHandle& node)
    : fixed_frame_(without_slash(fixed_frame)), timeout_s_(timeout_s), listener_(buffer_, node) {}

rigidformer::RigidTransform FrameTransformer::T_fixed_from(const std::string& frame_id, const ros::Time& stamp) const {
  return T_fixed_from(frame_id, stamp, timeout_s_);
}

rigidformer::RigidTransform FrameTransformer::T_fixed_from(const std::string& frame_id, const ros::Time& stamp,
                                                           double timeout_s) const {
  const std::string frame = without_slash(frame_id);
  if (frame == fixed_frame_) {
    return {};
  }
  if (frame.empty()) {
    throw TransformError("header.frame_id is empty, cannot be brought into '" + fixed_frame_ + "'");
  }
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout_s);
  while (true) {
    try {
      return to_transform(buffer_.lookupTransform(fixed_frame_, frame, stamp).transform);
    } catch (const tf2::TransformException& error) {
      if (ros::WallTime::now() >= deadline) {
        throw TransformError("no transform from '" + frame_id + "' to '" + fixed_frame_ + "' at " +
                             std::to_string(stamp.toSec()) + " s: " + error.what());
      }
    }
    ros::WallDuration(kPollPeriod).sleep();
  }
}

}  // namespace rigidformer_ros
