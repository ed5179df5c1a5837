// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/conversions.hpp"

#include <rigidformer_ros/ObjectClouds.h>

#include <stdexcept>
#include <string>

namespace rigidformer_ros {

namespace {

using rigidformer::MotionMode;
using rigidformer::RigidTransform;

template <typename Vector>
RigidTransform checked_transform(const Vector& translation, const geometry_msgs::Quaternion& q) {
  RigidTransform T{Eigen::Quaterniond(q.w, q.x, q.y, q.z), {translation.x, translation.y, translation.z}};
  if (!T.translation.allFinite()) {
    throw std::invalid_argument("position: is not finite");
  }
  if (!rigidformer::is_valid(T)) {
    throw std::invalid_argument("orientation: quaternion of length " + std::to_string(T.rotation.norm()) +
                                ", must be 1");
  }
  T.rotation.normalize();
  return T;
}

void require(bool accepted, const char* name, double value, const char* range) {
  if (!accepted) {
    throw std::invalid_argument(std::string(name) + ": is " + std::to_string(value) + ", must be " + range);
  }
}

}  // namespace

rigidformer::Stamp to_stamp(const ros::Time& time) {
  return rigidformer::Stamp(std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nsec));
}

ros::Time to_ros_time(rigidformer::Stamp stamp) {
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(stamp.time_since_epoch().count()));
  return time;
}

RigidTransform to_transform(const geometry_msgs::Pose& pose) {
  return checked_transform(pose.position, pose.orientation);
}

RigidTransform to_transform(const geometry_msgs::Transform& transform) {
  return checked_transform(transform.translation, transform.rotation);
}

geometry_msgs::Pose to_pose(const RigidTransform& T) {
  geometry_msgs::Pose pose;
  pose.position.x = T.translation.x();
  pose.position.y = T.translation.y();
  pose.position.z = T.translation.z();
  pose.orientation.x = T.rotation.x();
  pose.orientation.y = T.rotation.y();
  pose.orientation.z = T.rotation.z();
  pose.orientation.w = T.rotation.w();
  return pose;
}

geometry_msgs::Twist twist_between(const RigidTransform& before, const RigidTransform& after, double dt_s) {
  const Eigen::Vector3d linear = (after.translation - before.translation) / dt_s;
  const Eigen::Vector3d angular = rigidformer::rotation_vector(after.rotation * before.rotation.conjugate()) / dt_s;
  geometry_msgs::Twist twist;
  twist.linear.x = linear.x();
  twist.linear.y = linear.y();
  twist.linear.z = linear.z();
  twist.angular.x = angular.x();
  twist.angular.y = angular.y();
  twist.angular.z = angular.z();
  return twist;
}

MotionMode to_motion_mode(std::uint8_t mode) {
  switch (mode) {
    case ObjectClouds::DYNAMIC:
      return MotionMode::kDynamic;
    case ObjectClouds::KINEMATIC:
      return MotionMode::kKinematic;
    case ObjectClouds::STATIC:
      return MotionMode::kStatic;
    default:
      throw std::invalid_argument("is " + std::to_string(mode) + ", must be DYNAMIC 0, KINEMATIC 1 or STATIC 2");
  }
}

std::uint8_t to_message_mode(MotionMode mode) {
  switch (mode) {
    case MotionMode::kKinematic:
      return ObjectClouds::KINEMATIC;
    case MotionMode::kStatic:
      return ObjectClouds::STATIC;
    default:
      return ObjectClouds::DYNAMIC;
  }
}

rigidformer::BodyProperties to_properties(const PhysicalProperties& message) {
  rigidformer::BodyProperties properties;
  if ((message.known & PhysicalProperties::MASS) != 0) {
    require(message.mass > 0.0 && message.mass < 1e9, "mass", message.mass, "positive");
    properties.mass_kg = message.mass;
  }
  if ((message.known & PhysicalProperties::FRICTION) != 0) {
    require(message.friction >= 0.0 && message.friction < 1e3, "friction", message.friction, ">= 0");
    properties.friction = message.friction;
  }
  if ((message.known & PhysicalProperties::RESTITUTION) != 0) {
    require(message.restitution >= 0.0 && message.restitution <= 1.0, "restitution", message.restitution, "in [0, 1]");
    properties.restitution = message.restitution;
  }
  return properties;
}

}  // namespace rigidformer_ros
