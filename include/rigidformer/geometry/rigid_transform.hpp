// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace rigidformer {

/// N points as rows [N, 3], in metres and single precision, which is what sensors deliver and the network reads.
using Points = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A rigid motion or pose, named `T_target_source`: maps coordinates in `source` to `target`.
struct RigidTransform {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< Unit quaternion
  /// Position of the source frame's origin in the target frame [m].
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  RigidTransform inverse() const;

  /// Transforms every row of `points_source` [N, 3].
  Points apply(const Points& points_source) const;
};

Eigen::Vector3d operator*(const RigidTransform& T_target_source, const Eigen::Vector3d& point_source);
RigidTransform operator*(const RigidTransform& T_a_b, const RigidTransform& T_b_c);

/// The rotation vector, axis times angle [rad], of the shorter way round: at most pi long.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation);

/// The rotation about the vector's direction by its length [rad].
Eigen::Quaterniond rotation_about(const Eigen::Vector3d& rotation_vector);

/// Interpolates linearly in position and by slerp in rotation: `fraction` 0 gives `from`, 1 gives `to`,
/// and values outside extrapolate.
RigidTransform interpolate(const RigidTransform& from, const RigidTransform& to, double fraction);

/// Geodesic angle between the two rotations [rad], in [0, pi].
double rotation_angle(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

/// True when every coordinate is finite and the quaternion has unit length (to 1e-3).
bool is_valid(const RigidTransform& T);

}  // namespace rigidformer
