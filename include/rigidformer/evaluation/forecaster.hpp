// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/candidates.hpp"
#include "rigidformer/predictor.hpp"
#include "rigidformer/scene/object.hpp"

namespace rigidformer {

/// Anything that predicts motion from two given states: the network, or a baseline to compare it with.
class Forecaster {
 public:
  virtual ~Forecaster() = default;

  /// Name of the forecaster in tables and files, for example "ballistic".
  virtual std::string name() const = 0;

  /// Returns T_world_reference as [object][k] for k = 0 ... num_steps at times k *
  /// time_step_s; k = 0 is the observation. `tracks` are those of kinematic objects, by id; one without a track keeps
  /// its twist.
  virtual std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                            const RolloutOptions& rollout,
                                                            const std::vector<GivenTrack>& tracks = {}) = 0;
};

}  // namespace rigidformer
