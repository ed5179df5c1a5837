// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/rigid_registration.hpp"

#include <stdexcept>
#include <string>

namespace rigidformer {

RigidTransform fit_rigid_transform(const Points& source, const Points& target) {
  if (source.rows() != target.rows()) {
    throw std::invalid_argument("rigid registration: source has " + std::to_string(source.rows()) +
                                " points, target has " + std::to_string(target.rows()));
  }
  if (source.rows() < 3) {
    throw std::invalid_argument("rigid registration: " + std::to_string(source.rows()) + " points, needs at least 3");
  }
  if (!source.allFinite() || !target.allFinite()) {
    throw std::invalid_argument("rigid registration: points that are not finite");
  }
  const Eigen::Matrix3Xd from = source.transpose().cast<double>();
  const Eigen::Matrix3Xd to = target.transpose().cast<double>();
  const Eigen::Matrix4d T = Eigen::umeyama(from, to, /*with_scaling=*/false);
  return {Eigen::Quaterniond(Eigen::Matrix3d(T.topLeftCorner<3, 3>())).normalized(), T.topRightCorner<3, 1>()};
}

Eigen::VectorXd registration_residuals(const RigidTransform& T_target_source, const Points& source,
                                       const Points& target) {
  return (T_target_source.apply(source) - target).rowwise().norm().cast<double>();
}

}  // namespace rigidformer
