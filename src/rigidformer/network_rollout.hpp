// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "rigidformer/rollout_world.hpp"

namespace rigidformer {

/// One scene as it was observed, on its way through the network (paper §3).
class NetworkRollout : public Rollout {
 public:
  /// The network must outlive the rollout. Objects and options as for perceive(). Throws what perceive() throws.
  NetworkRollout(const StepMaker& maker, const torch::Device& device, int max_points,
                 const std::vector<ObjectState>& objects, const RolloutOptions& rollout);

  const Forecast& advance(int num_steps) override;

 private:
  Forecast forecast_;
  std::optional<RolloutWorld> world_;
};

}  // namespace rigidformer
