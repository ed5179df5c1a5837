// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "rigidformer/baselines/observed_body.hpp"
#include "rigidformer/evaluation/forecaster.hpp"

namespace rigidformer {

/// Bullet, given what the network sees (see observed_body.hpp), with the solver settings of the MOVi scenes and
/// one solver step per 240 Hz frame.
class BulletForecaster : public Forecaster {
 public:
  /// Bodies have one convex hull each, or the parts that `decompose` makes of their points.
  explicit BulletForecaster(std::string name = "bullet", Decomposition decompose = one_hull)
      : name_(std::move(name)), decompose_(std::move(decompose)) {}

  std::string name() const override { return name_; }

  /// Throws std::invalid_argument for what observe_bodies() refuses.
  std::vector<std::vector<RigidTransform>> forecast(const std::vector<ObjectState>& objects,
                                                    const RolloutOptions& rollout,
                                                    const std::vector<GivenTrack>& tracks = {}) override;

 private:
  std::string name_;
  Decomposition decompose_;
};

}  // namespace rigidformer
