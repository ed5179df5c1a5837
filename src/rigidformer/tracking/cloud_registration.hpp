// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/tracking/observation.hpp"
#include "rigidformer/tracking/options.hpp"
#include "rigidformer/tracking/reference_cloud.hpp"
#include "rigidformer/tracking/surface_cloud.hpp"

namespace rigidformer {

/// Number of points below which a cloud does not check the six unknowns of a pose. Chosen by eye.
constexpr Eigen::Index kMinRegisteredPoints = 10;

/// What the registration of one cloud found.
struct CloudRegistration {
  RigidTransform T_world_object;
  RegistrationQuality quality;
  std::string objection;  ///< Why the pose must not be trusted; empty = it may be
  /// The cloud's faces end elsewhere than the reference's: an end is hidden, or the pose has slid.
  bool may_have_slid = false;
};

/// Quality of a cloud of at least one point at a given pose of the reference; `objection` says what is wrong with it.
CloudRegistration measure_pose(const ReferenceCloud& reference, const SurfaceCloud& cloud_world,
                               const RigidTransform& T_world_object, const CorrespondenceOptions& parameters);

/// Finds the pose of the reference cloud in a new cloud (docs/tracking.md). Robust point-to-plane steps
/// (point-to-point where the reference has no normal) also hold the ends of faces in place. They start from
/// `T_world_predicted` or, where that fits clearly better, from `T_world_shifted`, with at most
/// `max_registered_points`. Where the cloud could then slide along its faces, the ends of these faces, seen in all
/// points, say how far it has slid. What the cloud does not determine, such as the spin of a ball, stays as predicted.
/// Fewer than `kMinRegisteredPoints` give an objection.
CloudRegistration register_cloud(const ReferenceCloud& reference, const SurfaceCloud& cloud_world,
                                 const RigidTransform& T_world_predicted, const RigidTransform& T_world_shifted,
                                 const CorrespondenceOptions& parameters);

}  // namespace rigidformer
