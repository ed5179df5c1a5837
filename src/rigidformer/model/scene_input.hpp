// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/options.hpp"
#include "rigidformer/scene/object.hpp"
#include "rigidformer/scene/rollout_options.hpp"

namespace rigidformer {

/// A scene in the form the network reads, B = 1. World coordinates are shifted so that the ground lies at z = 0 and the
/// objects surround the origin: physics does not depend on where a scene stands, trained positions do.
struct SceneInput {
  SceneBatch batch;
  SceneState state;
  Eigen::Vector3d origin_world;  ///< Position of the network's origin in world [m]
  std::vector<Points> clouds;    ///< Points the network uses, farthest-point order, reference frame
};

/// Checks every option; throws std::invalid_argument naming the one at fault.
void validate_options(const RolloutOptions& rollout);

/// Objects must be usable (scene/objection.hpp). Points are reduced to the first `max_points` in farthest-point order
/// and padded to a multiple of 16. Unknown material parameters are marked unknown when the model can read that;
/// otherwise MOVi's mean values stand in.
SceneInput make_scene_input(const std::vector<ObjectState>& objects, const RolloutOptions& rollout,
                            const ModelOptions& model, int max_points);

/// The parts of it that change when the same clouds are in other states: poses, and masks with material.
SceneState make_scene_state(const std::vector<ObjectState>& objects, const Eigen::Vector3d& origin_world);
void store_roles(const std::vector<ObjectState>& objects, const ModelOptions& model, SceneBatch& batch);

/// Writes a pose in world coordinates to row k of a batch of one scene.
void store_pose(const RigidTransform& T_world_reference, const Eigen::Vector3d& origin_world, Pose& pose,
                std::int64_t k);

/// Gives the poses of all objects in world coordinates.
std::vector<RigidTransform> to_world(const Pose& pose, const Eigen::Vector3d& origin_world);

}  // namespace rigidformer
