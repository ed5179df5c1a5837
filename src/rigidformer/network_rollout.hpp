// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "rigidformer/rollout_world.hpp"

namespace rigidformer {

/// One scene as it was observed, on its way through the network (paper §3), with particles for its doubt beside it.
class NetworkRollout : public Rollout {
 public:
  /// The network must outlive the rollout. Objects and options as for perceive(). Throws what perceive() throws.
  NetworkRollout(const StepMaker& maker, const torch::Device& device, int max_points,
                 const std::vector<ObjectState>& objects, const RolloutOptions& rollout);

  const Forecast& advance(int num_steps) override;

 private:
  /// The scene in the engine, of a material that is drawn where it is unknown.
  struct Particle {
    Forecast forecast;
    std::unique_ptr<RolloutWorld> world;
  };
  std::optional<Doubt> spread(std::size_t object, std::size_t step) const;

  std::optional<DoubtTable> doubt_;
  std::vector<MotionMode> modes_;
  Forecast forecast_;
  std::unique_ptr<RolloutWorld> world_;
  std::vector<std::unique_ptr<Particle>> particles_;
};

}  // namespace rigidformer
