// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/engine/observed_solid.hpp"
#include "rigidformer/model/batch.hpp"
#include "rigidformer/model/options.hpp"

namespace rigidformer {

/// Whether an engine may leave out what rests. What is put back by whoever holds it at rest after a step (rest.hpp) and
/// is where it was would be put back again: it sleeps until something comes to touch it.
enum class Sleep { kNever, kWhileHeld };

/// A physics engine on what the network sees: Bullet on the convex hulls of the clouds (see observed_hull.hpp) with the
/// network's centres of mass [B, K, 3], to be called with the states of one rollout. Unknown material is guessed by
/// each of the model's advisers (adviser_material.hpp). Empty for models without engine_motion. Throws BodyError for
/// the first object without a body, and std::runtime_error when the model needs an engine and none was there at build
/// time.
EngineStep make_engine_step(const ModelOptions& options, const SceneBatch& batch, const Tensor& centre_reference);

/// Whether Bullet was there at build time.
bool has_physics_engine();

/// The bodies of a batch of one scene, for make_engine_step(), make_contact_search() and SolidScene; none where Bullet
/// was not there at build time. Throws BodyError.
std::vector<ObservedSolid> make_solids(const SceneBatch& batch, const Tensor& centre_reference);

/// The same for a batch of one scene whose bodies are made already, whatever the model.
EngineStep make_engine_step(const SceneBatch& batch, const std::vector<ObservedSolid>& solids, int advisers,
                            Sleep sleep);

}  // namespace rigidformer
