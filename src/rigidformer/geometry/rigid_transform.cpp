// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/rigid_transform.hpp"

#include <algorithm>
#include <cmath>

namespace rigidformer {

RigidTransform RigidTransform::inverse() const {
  const Eigen::Quaterniond inverse_rotation = rotation.conjugate();
  return {inverse_rotation, -(inverse_rotation * translation)};
}

Points RigidTransform::apply(const Points& points_source) const {
  const Eigen::Matrix3f R = rotation.toRotationMatrix().cast<float>();
  return (points_source * R.transpose()).rowwise() + translation.cast<float>().transpose();
}

Eigen::Vector3d operator*(const RigidTransform& T_target_source, const Eigen::Vector3d& point_source) {
  return T_target_source.rotation * point_source + T_target_source.translation;
}

RigidTransform operator*(const RigidTransform& T_a_b, const RigidTransform& T_b_c) {
  return {(T_a_b.rotation * T_b_c.rotation).normalized(), T_a_b * T_b_c.translation};
}

Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation) {
  // Eigen gives angles up to 2 pi for quaternions of negative w.
  const Eigen::AngleAxisd turn(rotation);
  return (turn.angle() > M_PI ? turn.angle() - 2.0 * M_PI : turn.angle()) * turn.axis();
}

Eigen::Quaterniond rotation_about(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (!(angle > 0.0)) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation_vector / angle));
}

RigidTransform interpolate(const RigidTransform& from, const RigidTransform& to, double fraction) {
  const Eigen::Vector3d turn = rotation_vector(from.rotation.conjugate() * to.rotation);
  return {(from.rotation * rotation_about(fraction * turn)).normalized(),
          from.translation + fraction * (to.translation - from.translation)};
}

double rotation_angle(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.angularDistance(b); }

bool is_valid(const RigidTransform& T) {
  return T.translation.allFinite() && T.rotation.coeffs().allFinite() && std::abs(T.rotation.norm() - 1.0) < 1e-3;
}

}  // namespace rigidformer
