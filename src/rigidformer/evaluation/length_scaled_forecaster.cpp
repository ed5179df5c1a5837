// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "length_scaled_forecaster.hpp"

#include <utility>

#include "rigidformer/length_scale.hpp"

namespace rigidformer {

std::vector<std::vector<RigidTransform>> LengthScaledForecaster::forecast(const std::vector<ObjectState>& objects,
                                                                          const RolloutOptions& rollout,
                                                                          const std::vector<GivenTrack>& tracks) {
  Candidate given;
  given.tracks = tracks;
  auto poses = forecaster_.forecast(to_model_scale(objects, scale_), to_model_scale(rollout, scale_),
                                    to_model_scale(std::move(given), scale_).tracks);
  for (auto& object : poses) {
    for (RigidTransform& pose : object) pose.translation *= scale_;
  }
  return poses;
}

}  // namespace rigidformer
