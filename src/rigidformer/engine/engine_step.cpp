// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/engine_step.hpp"

#include <ATen/Parallel.h>

#include <memory>
#include <stdexcept>

#ifdef RIGIDFORMER_HAS_BULLET
#include "engine_scene.hpp"
#include "rigidformer/model/given_motion.hpp"
#endif

namespace rigidformer {

#ifdef RIGIDFORMER_HAS_BULLET

namespace {

using Scenes = std::vector<EngineScene>;

EngineStep step_of(const std::shared_ptr<Scenes>& scenes, const Tensor& none_certain) {
  return [scenes, none_certain](const SceneState& state) {
    torch::NoGradGuard no_grad;
    PoseTable current(state.current), previous(state.previous);
    const PoseTable coming(coming_pose(state));
    EngineMotion motion;
    Tensor certain = none_certain.clone();
    at::parallel_for(0, static_cast<std::int64_t>(scenes->size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (auto b = static_cast<size_t>(begin); b < static_cast<size_t>(end); ++b) {
        (*scenes)[b].step({previous, current, coming}, certain);
      }
    });
    for (const EngineScene& scene : *scenes) {
      const std::vector<PressedPair> pressed = scene.pressed();
      motion.pressed.insert(motion.pressed.end(), pressed.begin(), pressed.end());
    }
    motion.pose = current.to_pose(state.current);
    motion.departure = previous.to_pose(state.current);
    motion.certain = certain.to(state.current.rotation.device());
    return motion;
  };
}

}  // namespace

EngineStep make_engine_step(const ModelOptions& options, const SceneBatch& batch, const Tensor& centre_reference) {
  if (!options.engine_motion) return {};
  torch::NoGradGuard no_grad;
  const SceneBatch scene_batch = batch.to(torch::kCPU);  // one transfer per tensor instead of one per number
  const Tensor centre = centre_reference.to(torch::kCPU, torch::kFloat64);
  const auto scenes = std::make_shared<Scenes>();
  for (std::int64_t b = 0; b < batch.num_scenes(); ++b) {
    scenes->emplace_back(scene_batch, observe_solids(scene_batch, centre, b), b, Sleep::kNever);
  }
  return step_of(scenes, torch::zeros_like(scene_batch.object_mask));
}

bool has_physics_engine() { return true; }

std::vector<ObservedSolid> make_solids(const SceneBatch& batch, const Tensor& centre_reference) {
  return observe_solids(batch.to(torch::kCPU), centre_reference.to(torch::kCPU, torch::kFloat64), 0);
}

EngineStep make_engine_step(const SceneBatch& batch, const std::vector<ObservedSolid>& solids, Sleep sleep) {
  const SceneBatch scene_batch = batch.to(torch::kCPU);
  const auto scenes = std::make_shared<Scenes>();
  scenes->emplace_back(scene_batch, solids, 0, sleep);
  return step_of(scenes, torch::zeros_like(scene_batch.object_mask));
}

#else

EngineStep make_engine_step(const ModelOptions& options, const SceneBatch&, const Tensor&) {
  if (!options.engine_motion) return {};
  throw std::runtime_error("this model needs a physics engine: install libbullet-dev and build again");
}

bool has_physics_engine() { return false; }

std::vector<ObservedSolid> make_solids(const SceneBatch&, const Tensor&) { return {}; }

EngineStep make_engine_step(const SceneBatch&, const std::vector<ObservedSolid>&, Sleep) {
  throw std::runtime_error("a physics engine is needed: install libbullet-dev and build again");
}

#endif

}  // namespace rigidformer
