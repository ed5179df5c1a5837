// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/evaluation/forecaster.hpp"

namespace rigidformer {

/// The guess without learning and without contact: it keeps velocity and spin of the two given states and adds gravity,
/// in the Verlet form x_{k+1} = 2 x_k - x_{k-1} + g dt^2 that is exact for a parabola. Gravity acts on dynamic objects
/// only; static ones stay where they are.
class BallisticForecaster : public Forecaster {
 public:
  std::string name() const override { return "ballistic"; }

  /// Throws std::invalid_argument when `num_steps` or `time_step_s` is not positive.
  std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                    const RolloutOptions& rollout,
                                                    const std::vector<GivenTrack>& tracks = {}) override;
};

}  // namespace rigidformer
