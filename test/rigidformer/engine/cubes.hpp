// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/model/random_scene.hpp"

namespace rigidformer {

constexpr double kStepFrames = 10.0;
const double kTimeStep_s = kStepFrames / kFrameRateHz;

/// A small model inside of which an engine takes steps.
inline ModelOptions engine_options() {
  ModelOptions options = contact_aware(model_preset("tiny"));
  options.engine_motion = true;
  return options;
}

/// Unit cubes with known material above a floor, centre of mass in the origin of the reference frame.
struct Cubes {
  SceneBatch batch;
  SceneState state;
  Tensor centre;

  explicit Cubes(std::int64_t count) {
    const Tensor bits = torch::arange(8, torch::kInt64).unsqueeze(-1).bitwise_and(torch::tensor({1, 2, 4}));
    batch.points_reference = ((bits > 0).to(torch::kFloat64) - 0.5).expand({1, count, 8, 3}).clone();
    batch.point_mask = torch::ones({1, count, 8}, torch::kBool);
    batch.object_mask = torch::ones({1, count}, torch::kBool);
    batch.dynamic_mask = batch.object_mask.clone();
    batch.properties = torch::tensor({1.0, 0.5, 0.5}, torch::kFloat64).expand({1, count, 3}).clone();
    batch.properties_known = torch::ones({1, count, 3}, torch::kFloat64);
    batch.step_size = torch::full({1}, kStepFrames, torch::kFloat64);
    batch.ground_height = torch::zeros({1}, torch::kFloat64);
    batch.gravity = torch::full({1}, -10.0, torch::kFloat64);
    centre = torch::zeros({1, count, 3}, torch::kFloat64);
    const Tensor identity = torch::eye(3, torch::kFloat64).expand({1, count, 3, 3}).clone();
    state.first = state.previous = state.current = {identity, torch::zeros({1, count, 3}, torch::kFloat64)};
    state.previous.translation = state.current.translation.clone();
  }

  void place(std::int64_t k, const Eigen::Vector3d& position, const Eigen::Vector3d& velocity) {
    for (std::int64_t axis = 0; axis < 3; ++axis) {
      state.current.translation[0][k][axis] = position[axis];
      state.previous.translation[0][k][axis] = position[axis] - velocity[axis] * kTimeStep_s;
    }
  }
};

}  // namespace rigidformer
