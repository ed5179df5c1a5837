// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/time.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <stdexcept>
#include <string>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer_ros {

/// Says that there is no transform between two frames. what() names both frames and the stamp.
class TransformError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Brings poses and clouds into the fixed frame through tf.
class FrameTransformer {
 public:
  /// The transformer waits for a transform up to `timeout_s` seconds of wall time, so that a stopped clock cannot block
  /// it.
  FrameTransformer(std::string fixed_frame, double timeout_s, const ros::NodeHandle& node);

  /// Gives the transform from the frame into the fixed frame. Throws TransformError when there is none at `stamp`, and
  /// for an empty frame_id.
  rigidformer::RigidTransform T_fixed_from(const std::string& frame_id, const ros::Time& stamp) const;
  /// Gives the transform as above, but waits `timeout_s` instead of the time given to the constructor.
  rigidformer::RigidTransform T_fixed_from(const std::string& frame_id, const ros::Time& stamp, double timeout_s) const;

  const std::string& fixed_frame() const { return fixed_frame_; }

 private:
  std::string fixed_frame_;
  double timeout_s_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
};

}  // namespace rigidformer_ros
