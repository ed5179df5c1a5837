// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "rigidformer/tracking/cloud_registration.hpp"
#include "rigidformer/tracking/options.hpp"
#include "rigidformer/tracking/reference_cloud.hpp"

namespace rigidformer {

/// Follows one object through clouds that have no points in common: keeps its growing reference cloud and decides which
/// registrations to believe. docs/tracking.md describes the method.
class CloudTracker {
 public:
  /// `points_world` [N, 3] m, N >= 1, finite: the first cloud, which fixes the object frame.
  CloudTracker(const Points& points_world, const RigidTransform& T_world_object,
               const CorrespondenceOptions& parameters);

  /// Finds the pose in a new cloud [N, 3] m, N >= 1, finite. Where registration is refused (`objection`) the position
  /// follows the cloud's centre and the rotation is the predicted one. The answer is empty when the cloud is another
  /// object: its centre is farther than `max_jump_m` plus half the object's size from where it was predicted, or too
  /// many clouds in a row did not fit.
  std::optional<CloudRegistration> follow(const Points& points_world, const RigidTransform& T_world_previous,
                                          const RigidTransform& T_world_predicted, double max_jump_m);

  /// Judges a cloud of an object that stands still at `T_world_object`. Empty = too many clouds in a row did not fit.
  std::optional<CloudRegistration> stay(const Points& points_world, const RigidTransform& T_world_object);

  /// Whether a cloud lies on the reference cloud at `T_world_object`, as good as all of it. Changes nothing.
  bool lies_at(const Points& points_world, const RigidTransform& T_world_object) const;

  /// Takes in a cloud whose pose is known from elsewhere and measures how well the two agree.
  CloudRegistration learn(const Points& points_world, const RigidTransform& T_world_object);

  /// The reference cloud [M, 3] m in the object frame.
  const Points& points_object() const { return reference_.points(); }

 private:
  SurfaceCloud surface(const Points& points) const;
  CloudRegistration measure(const SurfaceCloud& cloud_world, const RigidTransform& T_world_object) const;
  /// Adds the surface that the cloud shows to the reference cloud.
  void grow(const SurfaceCloud& cloud_world, const RigidTransform& T_world_object);
  /// Counts failures and lets the reference grow from believed poses. Empty = too many failures in a row.
  std::optional<CloudRegistration> judge(const SurfaceCloud& cloud_world, const CloudRegistration& registration);

  CorrespondenceOptions parameters_;
  ReferenceCloud reference_;
  Eigen::Vector3d centre_world_;  ///< Median centre of the newest cloud [m]
  int failures_ = 0;              ///< Number of clouds in a row that did not fit
};

}  // namespace rigidformer
