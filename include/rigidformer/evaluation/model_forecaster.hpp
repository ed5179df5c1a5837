// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/evaluation/forecaster.hpp"

namespace rigidformer {

/// The network as one forecaster among others.
class ModelForecaster : public Forecaster {
 public:
  /// `predictor` must outlive the forecaster.
  explicit ModelForecaster(Predictor& predictor) : predictor_(predictor) {}

  std::string name() const override { return "rigidformer"; }

  /// Diverged objects keep their last finite pose and are scored with it.
  std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                    const RolloutOptions& rollout,
                                                    const std::vector<GivenTrack>& tracks = {}) override;

 private:
  Predictor& predictor_;
};

}  // namespace rigidformer
