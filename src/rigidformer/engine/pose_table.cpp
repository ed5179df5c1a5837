// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_table.hpp"

namespace rigidformer {
namespace {

using RowMatrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// A copy of its own.
Tensor to_table(const Tensor& tensor) { return torch::empty(tensor.sizes(), torch::kFloat64).copy_(tensor.detach()); }

}  // namespace

PoseTable::PoseTable(const Pose& pose) : rotation_(to_table(pose.rotation)), translation_(to_table(pose.translation)) {}

RigidTransform PoseTable::get(std::int64_t b, std::int64_t k) const {
  const std::int64_t row = b * rotation_.size(1) + k;
  const Eigen::Matrix3d R = Eigen::Map<const RowMatrix>(rotation_.data_ptr<double>() + 9 * row);
  return {Eigen::Quaterniond(R).normalized(),
          Eigen::Map<const Eigen::Vector3d>(translation_.data_ptr<double>() + 3 * row)};
}

void PoseTable::set(std::int64_t b, std::int64_t k, const RigidTransform& T) {
  const std::int64_t row = b * rotation_.size(1) + k;
  Eigen::Map<RowMatrix>(rotation_.data_ptr<double>() + 9 * row) = T.rotation.toRotationMatrix();
  Eigen::Map<Eigen::Vector3d>(translation_.data_ptr<double>() + 3 * row) = T.translation;
}

Pose PoseTable::to_pose(const Pose& like) const {
  return {rotation_.to(like.rotation.options()), translation_.to(like.translation.options())};
}

}  // namespace rigidformer
