// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <LinearMath/btTransform.h>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

inline btVector3 to_bullet(const Eigen::Vector3d& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

inline btTransform to_bullet(const RigidTransform& T) {
  const Eigen::Quaterniond q = T.rotation.normalized();
  return btTransform(btQuaternion(static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
                                  static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w())),
                     to_bullet(T.translation));
}

inline Eigen::Vector3d from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

inline RigidTransform from_bullet(const btTransform& T) {
  const btQuaternion q = T.getRotation();
  return {Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized(), from_bullet(T.getOrigin())};
}

}  // namespace rigidformer
