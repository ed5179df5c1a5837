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

/// Reads a pose. Throws std::invalid_argument when a coordinate is not finite or when the length of the quaternion
/// differs from 1 by more than 1e-3; smaller differences are removed.
rigidformer::RigidTransform to_transform(const geometry_msgs::Pose& pose);

/// Reads a transform. It is checked in the same way as a pose.
rigidformer::RigidTransform to_transform(const geometry_msgs::Transform& transform);

/// Writes a transform as a pose: position [m] and quaternion.
geometry_msgs::Pose to_pose(const rigidformer::RigidTransform& T);

/// Constant twist that leads from `before` to `after` in `dt_s` seconds: the velocity of the origin [m/s] and the
/// angular velocity [rad/s], both along the axes of the world.
geometry_msgs::Twist twist_between(const rigidformer::RigidTransform& before, const rigidformer::RigidTransform& after,
                                   double dt_s);

/// Turns a ROS time into a stamp of the core. Both count nanoseconds, so nothing is lost.
rigidformer::Stamp to_stamp(const ros::Time& time);

/// Turns a stamp of the core back into a ROS time, without loss.
ros::Time to_ros_time(rigidformer::Stamp stamp);

/// Turns a mode constant of ObjectClouds into a MotionMode. Throws std::invalid_argument for any other number.
rigidformer::MotionMode to_motion_mode(std::uint8_t mode);

/// Turns a MotionMode into a mode constant of ObjectClouds.
std::uint8_t to_message_mode(rigidformer::MotionMode mode);

/// Reads the properties that the message marks as known; the others stay unknown. Throws std::invalid_argument naming
/// the value that is out of range.
rigidformer::BodyProperties to_properties(const PhysicalProperties& properties);

}  // namespace rigidformer_ros
