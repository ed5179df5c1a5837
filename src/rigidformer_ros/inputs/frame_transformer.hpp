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

/// No transform between two frames; what() names both and the stamp.
class TransformError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Brings poses and clouds into the fixed frame through tf.
class FrameTransformer {
 public:
  /// Waits up to `timeout_s` of wall time for a transform, so that a stopped clock cannot block it.
  FrameTransformer(std::string fixed_frame, double timeout_s, const ros::NodeHandle& node);

  /// Throws TransformError when the transform does not exist at `stamp`. An empty frame_id throws too.
  rigidformer::RigidTransform T_fixed_from(const std::string& frame_id, const ros::Time& stamp) const;
  /// Same with a wait of its own [s].
  rigidformer::RigidTransform T_fixed_from(const std::string& frame_id, const ros::Time& stamp, double timeout_s) const;

  const std::string& fixed_frame() const { return fixed_frame_; }

 private:
  std::string fixed_frame_;
  double timeout_s_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
};

}  // namespace rigidformer_ros
