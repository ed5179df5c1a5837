// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Twist.h>
#include <rigidformer_ros/PhysicalProperties.h>
#include <ros/time.h>

#include <cstdint>

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/scene/object.hpp"
#include "rigidformer/tracking/stamp.hpp"

namespace rigidformer_ros {

/// Throws std::invalid_argument when a coordinate is not finite or the quaternion (x y z w) has no unit length (to
/// 1e-3).
rigidformer::RigidTransform to_transform(const geometry_msgs::Pose& pose);
rigidformer::RigidTransform to_transform(const geometry_msgs::Transform& transform);

geometry_msgs::Pose to_pose(const rigidformer::RigidTransform& T);

/// Constant twist [m/s, rad/s] that leads from `before` to `after` in `dt_s`: origin velocity and rotation, world axes.
geometry_msgs::Twist twist_between(const rigidformer::RigidTransform& before, const rigidformer::RigidTransform& after,
                                   double dt_s);

/// The same instant in the words of the core and of ROS, exactly.
rigidformer::Stamp to_stamp(const ros::Time& time);
ros::Time to_ros_time(rigidformer::Stamp stamp);

/// ObjectClouds mode constant to MotionMode and back. Throws std::invalid_argument for other numbers.
rigidformer::MotionMode to_motion_mode(std::uint8_t mode);
std::uint8_t to_message_mode(rigidformer::MotionMode mode);

/// Throws std::invalid_argument naming the value that is out of range.
rigidformer::BodyProperties to_properties(const PhysicalProperties& properties);

}  // namespace rigidformer_ros
