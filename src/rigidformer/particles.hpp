// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "rigidformer/candidates.hpp"
#include "rigidformer/rollout_world.hpp"

namespace rigidformer {

/// The steps of worlds that only tell how far unknowns part them: the engine's where there is one, which is cheaper.
StepMaker maker_of_particles(StepMaker maker);

/// What particle number `particle` takes for the unknown material of an object. It depends on nothing but these three,
/// so that all candidates of a request, and all requests with one seed, are judged in the same unknown worlds. The
/// ranges are those of real things in varied_scene.hpp. Particle 0 draws nothing: the forecast's own means stand for
/// it.
BodyProperties drawn_material(const std::string& object_id, int particle, std::uint64_t seed);

/// The candidate in the world of a particle: what it leaves unknown of the scene's dynamic objects is drawn.
Candidate in_world_of(int particle, std::uint64_t seed, const Candidate& candidate,
                      const std::vector<ObjectState>& scene);

/// All candidates in the worlds of all particles: those of the first candidate, then those of the next one.
std::vector<Candidate> in_all_worlds(const std::vector<Candidate>& candidates, const std::vector<ObjectState>& scene,
                                     const RolloutOptions& rollout);

}  // namespace rigidformer
