// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/model/batch.hpp"

namespace rigidformer {

/// Poses of a batch on the CPU in double precision, one by one.
class PoseTable {
 public:
  explicit PoseTable(const Pose& pose);

  RigidTransform get(std::int64_t b, std::int64_t k) const;
  void set(std::int64_t b, std::int64_t k, const RigidTransform& T);

  /// In the type and on the device of `like`.
  Pose to_pose(const Pose& like) const;

 private:
  Tensor rotation_, translation_;
};

}  // namespace rigidformer
