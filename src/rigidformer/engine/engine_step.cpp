// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/engine_step.hpp"

#include <ATen/Parallel.h>

#include <memory>
#include <stdexcept>

#ifdef RIGIDFORMER_HAS_BULLET
#include "engine_scene.hpp"
#endif

namespace rigidformer {

#ifdef RIGIDFORMER_HAS_BULLET

EngineStep make_engine_step(const ModelOptions& options, const SceneBatch& batch, const Tensor& centre_reference) {
  if (!options.engine_motion) return {};
  torch::NoGradGuard no_grad;
  const auto scenes = std::make_shared<std::vector<EngineScene>>();
  const SceneBatch scene_batch = batch.to(torch::kCPU);  // one transfer per tensor instead of one per number
  const Tensor centre = centre_reference.to(torch::kCPU, torch::kFloat64);
  const std::int64_t B = batch.num_scenes();
  for (std::int64_t b = 0; b < B; ++b) scenes->emplace_back(scene_batch, centre, b);
  const Tensor none_certain = torch::zeros_like(scene_batch.object_mask);
  return [scenes, none_certain, B](const SceneState& state) {
    torch::NoGradGuard no_grad;
    PoseTable current(state.current), previous(state.previous);
    Tensor certain = none_certain.clone();
    at::parallel_for(0, B, 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t b = begin; b < end; ++b) (*scenes)[static_cast<size_t>(b)].step(previous, current, certain);
    });
    return EngineMotion{current.to_pose(state.current), previous.to_pose(state.current),
                        certain.to(state.current.rotation.device())};
  };
}

#else

EngineStep make_engine_step(const ModelOptions& options, const SceneBatch&, const Tensor&) {
  if (!options.engine_motion) return {};
  throw std::runtime_error("this model needs a physics engine: install libbullet-dev and build again");
}

#endif

}  // namespace rigidformer
