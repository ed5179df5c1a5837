// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/engine_step.hpp"

#include <ATen/Parallel.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#ifdef RIGIDFORMER_HAS_BULLET
#include "adviser_material.hpp"
#include "engine_scene.hpp"
#include "rigidformer/model/given_motion.hpp"
#endif

namespace rigidformer {

#ifdef RIGIDFORMER_HAS_BULLET

namespace {

/// The scenes of a batch as one adviser sees them.
using Scenes = std::vector<EngineScene>;
using AdvisedScenes = std::vector<Scenes>;

EngineMotion motion_of(Scenes& scenes, const SceneState& state) {
  PoseTable current(state.current), previous(state.previous);
  const PoseTable coming(coming_pose(state));
  at::parallel_for(0, static_cast<std::int64_t>(scenes.size()), 1, [&](std::int64_t begin, std::int64_t end) {
    for (auto b = static_cast<size_t>(begin); b < static_cast<size_t>(end); ++b) {
      scenes[b].step({previous, current, coming});
    }
  });
  EngineMotion motion{current.to_pose(state.current), previous.to_pose(state.current)};
  for (const EngineScene& scene : scenes) {
    const std::vector<PressedPair> pressed = scene.pressed();
    motion.pressed.insert(motion.pressed.end(), pressed.begin(), pressed.end());
  }
  return motion;
}

/// Where there is nothing to guess, one adviser speaks for all.
EngineStep step_of(AdvisedScenes advised_scenes, int advisers) {
  const auto advised = std::make_shared<AdvisedScenes>(std::move(advised_scenes));
  return [advised, advisers](const SceneState& state) {
    torch::NoGradGuard no_grad;
    std::vector<EngineMotion> advice;
    for (Scenes& scenes : *advised) advice.push_back(motion_of(scenes, state));
    advice.resize(static_cast<size_t>(advisers), advice.front());
    return advice;
  };
}

bool is_guessed(const std::vector<ObservedSolid>& solids) {
  return std::any_of(solids.begin(), solids.end(),
                     [](const ObservedSolid& solid) { return !solid.known.friction || !solid.known.restitution; });
}

EngineStep advised_step(const SceneBatch& batch, const std::vector<std::vector<ObservedSolid>>& solids, int advisers,
                        Sleep sleep) {
  const bool guess = std::any_of(solids.begin(), solids.end(), is_guessed);
  AdvisedScenes advised(guess ? static_cast<size_t>(advisers) : 1);
  for (size_t adviser = 0; adviser < advised.size(); ++adviser) {
    for (size_t b = 0; b < solids.size(); ++b) {
      const std::vector<ObservedSolid> guessed = guess_material(solids[b], kAdviserMaterials[adviser]);
      advised[adviser].emplace_back(batch, guessed, static_cast<std::int64_t>(b), sleep);
    }
  }
  return step_of(std::move(advised), advisers);
}

}  // namespace

EngineStep make_engine_step(const ModelOptions& options, const SceneBatch& batch, const Tensor& centre_reference) {
  if (!options.engine_motion) return {};
  torch::NoGradGuard no_grad;
  const SceneBatch scene_batch = batch.to(torch::kCPU);  // one transfer per tensor instead of one per number
  const Tensor centre = centre_reference.to(torch::kCPU, torch::kFloat64);
  std::vector<std::vector<ObservedSolid>> solids;
  for (std::int64_t b = 0; b < batch.num_scenes(); ++b) solids.push_back(observe_solids(scene_batch, centre, b));
  return advised_step(scene_batch, solids, options.advisers, Sleep::kNever);
}

bool has_physics_engine() { return true; }

std::vector<ObservedSolid> make_solids(const SceneBatch& batch, const Tensor& centre_reference) {
  return observe_solids(batch.to(torch::kCPU), centre_reference.to(torch::kCPU, torch::kFloat64), 0);
}

EngineStep make_engine_step(const SceneBatch& batch, const std::vector<ObservedSolid>& solids, int advisers,
                            Sleep sleep) {
  return advised_step(batch.to(torch::kCPU), {solids}, advisers, sleep);
}

#else

EngineStep make_engine_step(const ModelOptions& options, const SceneBatch&, const Tensor&) {
  if (!options.engine_motion) return {};
  throw std::runtime_error("this model needs a physics engine: install libbullet-dev and build again");
}

bool has_physics_engine() { return false; }

std::vector<ObservedSolid> make_solids(const SceneBatch&, const Tensor&) { return {}; }

EngineStep make_engine_step(const SceneBatch&, const std::vector<ObservedSolid>&, int, Sleep) {
  throw std::runtime_error("a physics engine is needed: install libbullet-dev and build again");
}

#endif

}  // namespace rigidformer
