// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "rigidformer/scene/object.hpp"
#include "rigidformer/scene/rollout_options.hpp"
#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {

/// What a physics engine can make of one observed object. The body frame has the axes of the reference frame and its
/// origin in the assumed centre of mass; poses are relative to the ground: z = 0 is the floor.
struct ObservedBody {
  std::vector<ConvexPart> parts;  ///< Body frame [m]
  RigidTransform T_reference_body;
  BodyState state;            ///< At the current observation
  BodyProperties properties;  ///< Complete
  bool is_given = false;      ///< Nothing pushes it: static or kinematic
};

/// Makes convex parts of a cloud that spans a volume.
using Decomposition = std::function<std::vector<ConvexPart>(const Points&)>;

/// The convex hull as the only part.
std::vector<ConvexPart> one_hull(const Points& points);

/// Geometry, state and material from what the network sees and nothing else:
/// - Shape: what `decompose` makes of the points. Clouds thinner than 1 cm along a principal axis (one face, a
///   line) are made 1 cm thick there, half to each side.
/// - Centre of mass: centroid of the shape's volume, whatever the origin of the reference frame.
/// - Velocity and spin: from the two poses. Gravity is taken to have acted between them, except on objects that touch
///   the floor in both.
/// - Unknown material: the means of the MOVi scenes, as for the engine inside of the network.
/// - Static and kinematic objects are moved by their path: see given_path().
/// Throws std::invalid_argument for a bad rollout, no ground, or fewer than 4 points.
std::vector<ObservedBody> observe_bodies(const std::vector<ObjectState>& objects, const RolloutOptions& rollout,
                                         const Decomposition& decompose = one_hull);

/// The path, relative to the ground, of a body whose reference frame is at these poses after every step.
MotionPath given_path(const ObservedBody& body, const std::vector<RigidTransform>& T_world_reference,
                      const RolloutOptions& rollout);

/// T_world_reference of a body whose pose relative to the ground is `T_ground_body`.
RigidTransform reference_pose(const ObservedBody& body, const RigidTransform& T_ground_body,
                              const RolloutOptions& rollout);

}  // namespace rigidformer
