// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "rigidformer/candidate_objects.hpp"

namespace rigidformer {

/// T_world_reference of an object that is not dynamic, at the beginning of a rollout and after every step: where its
/// track says, or without one where a static object stays, or where the step between its two poses takes a kinematic
/// one again and again.
inline std::vector<RigidTransform> given_poses(const ObjectState& object, const RolloutOptions& rollout,
                                               const std::vector<GivenTrack>& tracks) {
  const auto track =
      std::find_if(tracks.begin(), tracks.end(), [&](const GivenTrack& of) { return of.id == object.id; });
  const RigidTransform &before = object.T_world_previous, &now = object.T_world_current;
  const bool moves = object.mode == MotionMode::kKinematic;
  const Eigen::Vector3d step = moves ? Eigen::Vector3d(now.translation - before.translation) : Eigen::Vector3d::Zero();
  const Eigen::Quaterniond turn = moves ? now.rotation * before.rotation.conjugate() : Eigen::Quaterniond::Identity();
  std::vector<RigidTransform> poses{now};
  for (int k = 1; k <= rollout.num_steps; ++k) {
    const RigidTransform& last = poses.back();
    poses.push_back(track != tracks.end()
                        ? pose_at(*track, k * rollout.time_step_s)
                        : RigidTransform{(turn * last.rotation).normalized(), last.translation + step});
  }
  return poses;
}

}  // namespace rigidformer
