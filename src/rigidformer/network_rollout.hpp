// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/engine/engine_step.hpp"
#include "rigidformer/model/rest.hpp"
#include "rigidformer/model/rigidformer.hpp"
#include "rigidformer/model/scene_input.hpp"
#include "rigidformer/rollout.hpp"

namespace rigidformer {

/// One scene on its way through the network (paper §3). What stays the same from step to step is made once: the order
/// of the points, their search trees, the centres of mass and the engine's hulls.
class NetworkRollout : public Rollout {
 public:
  /// The network must outlive the rollout. At least one object; objects are usable and options valid. The network looks
  /// at `max_points` points per object; larger clouds are thinned evenly. Throws what make_engine_step() throws.
  NetworkRollout(RigidFormer& model, const torch::Device& device, int max_points, const RestLimits& rest,
                 const std::vector<ObjectState>& objects, const RolloutOptions& rollout);

  const Forecast& advance(int num_steps) override;

 private:
  void step();
  void record(SceneState& next);
  void freeze(SceneState& next, std::int64_t k);

  RigidFormer model_;
  RestLimits rest_;
  RolloutOptions rollout_;
  SceneInput input_;
  SceneBatch batch_;
  SceneState state_;
  NearestSearch nearest_;
  Tensor centre_;  ///< Of mass, reference frame [1, K, 3]
  EngineStep engine_;
  ContactSearch contacts_;
  Forecast forecast_;
};

}  // namespace rigidformer
