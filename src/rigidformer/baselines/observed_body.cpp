// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/observed_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "rigidformer/simulation/convex_hull.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {
namespace {

constexpr double kTouching_m = 0.01;     // of the floor; sampled points miss the lowest corner by a little
constexpr double kUnknownDensity = 1.0;  // [kg/m^3]
constexpr double kUnknownFriction = 0.5;
constexpr double kUnknownRestitution = 0.5;
constexpr double kSolverRate_hz = 240.0;

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument("physics engine: " + message);
}

double lowest_point(const std::vector<ConvexPart>& parts, const RigidTransform& T_ground_body) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const ConvexPart& part : parts) {
    lowest = std::min<double>(lowest, T_ground_body.apply(part.vertices).col(2).minCoeff());
  }
  return lowest;
}

RigidTransform on_ground(const RigidTransform& T_world_reference, const ObservedBody& body,
                         const RolloutOptions& rollout) {
  RigidTransform T_ground_reference = T_world_reference;
  T_ground_reference.translation.z() -= *rollout.ground_height_m;
  return T_ground_reference * body.T_reference_body;
}

/// Motion at the later of two poses.
BodyState state_from_two_poses(const ObservedBody& body, const ObjectState& object, const RolloutOptions& rollout) {
  const RigidTransform before = on_ground(object.T_world_previous, body, rollout);
  BodyState state;
  state.T_world_object = on_ground(object.T_world_current, body, rollout);
  state.velocity = (state.T_world_object.translation - before.translation) / rollout.time_step_s;
  const bool on_floor =
      lowest_point(body.parts, before) < kTouching_m && lowest_point(body.parts, state.T_world_object) < kTouching_m;
  if (!on_floor) state.velocity.z() += 0.5 * rollout.gravity * rollout.time_step_s;
  state.angular_velocity =
      rotation_vector(state.T_world_object.rotation * before.rotation.conjugate()) / rollout.time_step_s;
  return state;
}

ObservedBody observe_body(const ObjectState& object, const RolloutOptions& rollout, const Decomposition& decompose) {
  require(object.mode != MotionMode::kKinematic, "object '" + object.id + "' is kinematic, which is not simulated");
  require(
      object.points_reference.rows() >= 4,
      "object '" + object.id + "' has " + std::to_string(object.points_reference.rows()) + " points, needs at least 4");
  require(object.points_reference.allFinite(), "object '" + object.id + "' has points that are not finite");
  ObservedBody body;
  body.parts = decompose(with_thickness(object.points_reference));
  const MeshVolume measured = measure_volume(body.parts);
  body.T_reference_body.translation = measured.centroid;
  for (ConvexPart& part : body.parts) part.vertices.rowwise() -= measured.centroid.transpose().cast<float>();
  body.is_static = object.mode == MotionMode::kStatic;
  body.state = state_from_two_poses(body, object, rollout);
  if (body.is_static) body.state = {body.state.T_world_object, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  body.properties.mass_kg = object.properties.mass_kg.value_or(kUnknownDensity * measured.volume_m3);
  body.properties.friction = object.properties.friction.value_or(kUnknownFriction);
  body.properties.restitution = object.properties.restitution.value_or(kUnknownRestitution);
  return body;
}

}  // namespace

std::vector<ConvexPart> one_hull(const Points& points) { return {convex_hull(points)}; }

std::vector<ObservedBody> observe_bodies(const std::vector<ObjectState>& objects, const RolloutOptions& rollout,
                                         const Decomposition& decompose) {
  require(rollout.num_steps >= 1, "num_steps is " + std::to_string(rollout.num_steps) + ", must be at least 1");
  require(rollout.time_step_s > 0.0, "time_step_s is " + std::to_string(rollout.time_step_s) + ", must be positive");
  require(rollout.ground_height_m.has_value(), "needs a ground");
  std::vector<ObservedBody> bodies;
  for (const ObjectState& object : objects) bodies.push_back(observe_body(object, rollout, decompose));
  return bodies;
}

RigidTransform reference_pose(const ObservedBody& body, const RigidTransform& T_ground_body,
                              const RolloutOptions& rollout) {
  RigidTransform T_world_reference = T_ground_body * body.T_reference_body.inverse();
  T_world_reference.translation.z() += *rollout.ground_height_m;
  return T_world_reference;
}

int substeps_per_step(const RolloutOptions& rollout) {
  return std::max(1, static_cast<int>(std::lround(kSolverRate_hz * rollout.time_step_s)));
}

}  // namespace rigidformer
