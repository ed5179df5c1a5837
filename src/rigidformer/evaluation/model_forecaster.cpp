// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/model_forecaster.hpp"

#include <stdexcept>
#include <utility>

namespace rigidformer {

std::vector<std::vector<RigidTransform>> ModelForecaster::forecast(const std::vector<ObjectState>& objects,
                                                                   const RolloutOptions& rollout) {
  std::vector<std::vector<RigidTransform>> poses;
  for (ObjectTrajectory& object : predictor_.predict(objects, rollout).objects) {
    if (object.status == ObjectTrajectory::Status::kUnusable) {  // no score for what was not predicted
      throw std::invalid_argument("object '" + object.id + "': " + object.reason);
    }
    object.poses.resize(rollout.num_steps + 1, object.poses.back());
    poses.push_back(std::move(object.poses));
  }
  return poses;
}

}  // namespace rigidformer
