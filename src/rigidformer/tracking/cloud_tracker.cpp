// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/cloud_tracker.hpp"

#include <algorithm>
#include <vector>

namespace rigidformer {

namespace {

constexpr Eigen::Index kMaxReferenceInput = 2000;  // points of one cloud that are used; chosen by eye
// Share of a cloud on the reference from which it lies in the same place: the rest is noise. What slides along its
// faces shows its end. Chosen by eye.
constexpr double kLiesThere = 0.95;
constexpr double kMaxJump = 0.5;  // [size] jump of a centre; derived: one object does not reach into another

// The centre is the median of each coordinate, in which stray points have no weight.
Eigen::Vector3d centre_of(const Points& points) {
  Eigen::Vector3d centre;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<float> values(static_cast<std::size_t>(points.rows()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = points(static_cast<Eigen::Index>(i), axis);
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    centre[axis] = *middle;
  }
  return centre;
}

// The previous pose, turned about the cloud's centre as predicted, and moved with that centre.
RigidTransform follow_centre(const RigidTransform& T_world_previous, const RigidTransform& T_world_predicted,
                             const Eigen::Vector3d& centre_before, const Eigen::Vector3d& centre_now) {
  const Eigen::Quaterniond turn = T_world_predicted.rotation * T_world_previous.rotation.conjugate();
  return {T_world_predicted.rotation, centre_now + turn * (T_world_previous.translation - centre_before)};
}

}  // namespace

CloudTracker::CloudTracker(const Points& points_world, const RigidTransform& T_world_object,
                           const CorrespondenceOptions& parameters)
    : parameters_(parameters),
      reference_(transform(T_world_object.inverse(),
                           estimate_surface(thin(points_world, kMaxReferenceInput), parameters.noise)),
                 parameters),
      centre_world_(centre_of(points_world)) {}

std::optional<CloudRegistration> CloudTracker::follow(const Points& points_world,
                                                      const RigidTransform& T_world_previous,
                                                      const RigidTransform& T_world_predicted, double max_jump_m) {
  // The steps are those of docs/tracking.md, "One cloud, step by step".
  // Step 2: a centre too far from where it was expected belongs to another object.
  const Eigen::Vector3d centre = centre_of(points_world);
  const Eigen::Vector3d centre_predicted = T_world_predicted * (T_world_previous.inverse() * centre_world_);
  if ((centre - centre_predicted).norm() > kMaxJump * reference_.size_m() + max_jump_m) {
    return std::nullopt;
  }
  // Step 3: besides the predicted start there is one that moves with the cloud's centre.
  const RigidTransform T_world_shifted = follow_centre(T_world_previous, T_world_predicted, centre_world_, centre);
  centre_world_ = centre;
  // Step 1: the cloud is thinned, and its normals are estimated.
  const SurfaceCloud cloud_world = surface(points_world);
  // Steps 3 to 5: registration chooses the start, minimises the distances and takes slides out.
  CloudRegistration registration =
      register_cloud(reference_, cloud_world, T_world_predicted, T_world_shifted, parameters_);
  // A pose that cannot be trusted is replaced by the one that follows the centre.
  if (!registration.objection.empty()) {
    registration.T_world_object = T_world_shifted;
  }
  // Step 6: the pose is judged, and the reference cloud grows from a good one.
  return judge(cloud_world, registration);
}

std::optional<CloudRegistration> CloudTracker::stay(const Points& points_world, const RigidTransform& T_world_object) {
  centre_world_ = centre_of(points_world);
  const SurfaceCloud cloud_world = surface(points_world);
  return judge(cloud_world, measure(cloud_world, T_world_object));
}

bool CloudTracker::lies_at(const Points& points_world, const RigidTransform& T_world_object) const {
  const CloudRegistration measured = measure(surface(points_world), T_world_object);
  return measured.objection.empty() && measured.quality.inlier_ratio >= kLiesThere;
}

CloudRegistration CloudTracker::learn(const Points& points_world, const RigidTransform& T_world_object) {
  centre_world_ = centre_of(points_world);
  const SurfaceCloud cloud_world = surface(points_world);
  const CloudRegistration registration = measure(cloud_world, T_world_object);
  grow(cloud_world, T_world_object);
  return registration;
}

SurfaceCloud CloudTracker::surface(const Points& points) const {
  return estimate_surface(thin(points, kMaxReferenceInput), parameters_.noise);
}

CloudRegistration CloudTracker::measure(const SurfaceCloud& cloud_world, const RigidTransform& T_world_object) const {
  return measure_pose(reference_, thin(cloud_world, parameters_.max_registered_points), T_world_object, parameters_);
}

void CloudTracker::grow(const SurfaceCloud& cloud_world, const RigidTransform& T_world_object) {
  reference_.grow(transform(T_world_object.inverse(), cloud_world));
}

std::optional<CloudRegistration> CloudTracker::judge(const SurfaceCloud& cloud_world,
                                                     const CloudRegistration& registration) {
  if (registration.objection.empty()) {
    failures_ = 0;
    // A side learned in a doubtful place would hold every later cloud in that place.
    if (!registration.may_have_slid) {
      grow(cloud_world, registration.T_world_object);
    }
    return registration;
  }
  failures_ +=
      cloud_world.points.rows() >= kMinRegisteredPoints ? 1 : 0;  // fewer points would make no better reference
  if (failures_ > parameters_.max_failures) {
    return std::nullopt;
  }
  return registration;
}

}  // namespace rigidformer
