// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/ballistic.hpp"

#include <stdexcept>
#include <string>

#include "given_poses.hpp"

namespace rigidformer {
namespace {

std::vector<RigidTransform> fly(const ObjectState& object, const RolloutOptions& rollout) {
  const Eigen::Vector3d fall_per_step(0.0, 0.0, rollout.gravity * rollout.time_step_s * rollout.time_step_s);
  const Eigen::Quaterniond turn = object.T_world_current.rotation * object.T_world_previous.rotation.conjugate();
  Eigen::Vector3d increment = object.T_world_current.translation - object.T_world_previous.translation;
  std::vector<RigidTransform> poses{object.T_world_current};
  for (int k = 0; k < rollout.num_steps; ++k) {
    increment += fall_per_step;
    poses.push_back({(turn * poses.back().rotation).normalized(), poses.back().translation + increment});
  }
  return poses;
}

}  // namespace

std::vector<std::vector<RigidTransform>> BallisticForecaster::forecast(const std::vector<ObjectState>& objects,
                                                                       const RolloutOptions& rollout,
                                                                       const std::vector<GivenTrack>& tracks) {
  if (rollout.num_steps < 1) {
    throw std::invalid_argument("ballistic: num_steps is " + std::to_string(rollout.num_steps) +
                                ", must be at least 1");
  }
  if (!(rollout.time_step_s > 0.0)) {
    throw std::invalid_argument("ballistic: time_step_s is " + std::to_string(rollout.time_step_s) +
                                ", must be positive");
  }
  std::vector<std::vector<RigidTransform>> poses;
  for (const ObjectState& object : objects) {
    poses.push_back(object.mode == MotionMode::kDynamic ? fly(object, rollout) : given_poses(object, rollout, tracks));
  }
  return poses;
}

}  // namespace rigidformer
