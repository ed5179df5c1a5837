// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/evaluation/forecaster.hpp"

namespace rigidformer {

/// A forecaster made for objects of a metre, as the networks and the solver settings of the engines are, on objects of
/// another size: it sees lengths divided by `scale` and times by its root, and its answer is mapped back.
class LengthScaledForecaster : public Forecaster {
 public:
  /// `forecaster` must outlive this one.
  LengthScaledForecaster(Forecaster& forecaster, double scale) : forecaster_(forecaster), scale_(scale) {}

  std::string name() const override { return forecaster_.name(); }

  std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                    const RolloutOptions& rollout,
                                                    const std::vector<GivenTrack>& tracks = {}) override;

 private:
  Forecaster& forecaster_;
  double scale_;
};

}  // namespace rigidformer
