// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/observed_body.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "rigidformer/simulation/convex_hull.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"
#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {
namespace {

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument("physics engine: " + message);
}

bool touches_floor(const ObservedBody& body, const RigidTransform& T_ground_body) {
  return std::any_of(body.parts.begin(), body.parts.end(),
                     [&](const ConvexPart& part) { return touches_floor(part.vertices, T_ground_body); });
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
  BodyState state = mean_motion(before, on_ground(object.T_world_current, body, rollout), rollout.time_step_s);
  const bool on_floor = touches_floor(body, before) && touches_floor(body, state.T_world_object);
  if (!on_floor) state.velocity.z() += half_fall(rollout.time_step_s, rollout.gravity);
  return state;
}

ObservedBody observe_body(const ObjectState& object, const RolloutOptions& rollout, const Decomposition& decompose) {
  require(
      object.points_reference.rows() >= 4,
      "object '" + object.id + "' has " + std::to_string(object.points_reference.rows()) + " points, needs at least 4");
  require(object.points_reference.allFinite(), "object '" + object.id + "' has points that are not finite");
  ObservedBody body;
  body.parts = decompose(with_thickness(object.points_reference));
  const MeshVolume measured = measure_volume(body.parts);
  body.T_reference_body.translation = measured.centroid;
  for (ConvexPart& part : body.parts) part.vertices.rowwise() -= measured.centroid.transpose().cast<float>();
  body.is_given = object.mode != MotionMode::kDynamic;
  body.state = state_from_two_poses(body, object, rollout);
  body.properties = with_means(object.properties, measured.volume_m3);
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

MotionPath given_path(const ObservedBody& body, const std::vector<RigidTransform>& T_world_reference,
                      const RolloutOptions& rollout) {
  std::vector<RigidTransform> poses;
  for (const RigidTransform& T : T_world_reference) poses.push_back(on_ground(T, body, rollout));
  return [poses, step_s = rollout.time_step_s](double time_s) {
    const double step = std::clamp(time_s / step_s, 0.0, static_cast<double>(poses.size() - 1));
    const auto before = static_cast<std::size_t>(step), after = std::min(before + 1, poses.size() - 1);
    return interpolate(poses[before], poses[after], step - static_cast<double>(before));
  };
}

RigidTransform reference_pose(const ObservedBody& body, const RigidTransform& T_ground_body,
                              const RolloutOptions& rollout) {
  RigidTransform T_world_reference = T_ground_body * body.T_reference_body.inverse();
  T_world_reference.translation.z() += *rollout.ground_height_m;
  return T_world_reference;
}

}  // namespace rigidformer
