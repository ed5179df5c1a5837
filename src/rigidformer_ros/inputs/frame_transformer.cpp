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

}  // namespace

FrameTransformer::FrameTransformer(std::string fixed_frame, double timeout_s, const ros::NodeHandle& node)
    : fixed_frame_(std::move(fixed_frame)), timeout_s_(timeout_s), listener_(buffer_, node) {}

rigidformer::RigidTransform FrameTransformer::T_fixed_from(const std::string& frame_id, const ros::Time& stamp) const {
  return T_fixed_from(frame_id, stamp, timeout_s_);
}

rigidformer::RigidTransform FrameTransformer::T_fixed_from(const std::string& frame_id, const ros::Time& stamp,
                                                           double timeout_s) const {
  if (frame_id == fixed_frame_) {
    return {};
  }
  if (frame_id.empty()) {
    throw TransformError("header.frame_id is empty, cannot be brought into '" + fixed_frame_ + "'");
  }
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout_s);
  while (true) {
    try {
      return to_transform(buffer_.lookupTransform(fixed_frame_, frame_id, stamp).transform);
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
