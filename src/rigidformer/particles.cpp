// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/particles.hpp"

#include <algorithm>
#include <random>

#include "rigidformer/engine/engine_step.hpp"

namespace rigidformer {
namespace {

// Real things from steel to rubber (simulation/varied_scene.hpp), in the middle of which the means lie.
constexpr double kMinFriction = 0.1, kMaxFriction = 1.1;
constexpr double kMinRestitution = 0.1, kMaxRestitution = 0.9;

/// FNV-1a: std::hash may differ between libraries.
std::uint64_t hash(const std::string& text) {
  std::uint64_t value = 14695981039346656037ull;
  for (const char letter : text) value = (value ^ static_cast<unsigned char>(letter)) * 1099511628211ull;
  return value;
}

/// In [min, max); the distributions of the standard library may differ between libraries.
double uniform(std::mt19937_64& random, double min, double max) {
  return min + (max - min) * static_cast<double>(random() >> 11) * 0x1p-53;
}

bool contains(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// The change of that object, which is made where there is none.
StateChange& change_of(const std::string& id, Candidate& candidate) {
  const auto has_id = [&](const StateChange& change) { return change.id == id; };
  const auto found = std::find_if(candidate.changes.begin(), candidate.changes.end(), has_id);
  if (found != candidate.changes.end()) return *found;
  candidate.changes.emplace_back();
  candidate.changes.back().id = id;
  return candidate.changes.back();
}

}  // namespace

StepMaker maker_of_particles(StepMaker maker) {
  if (has_physics_engine()) maker.fidelity = Fidelity::kEngine;
  maker.doubt.reset();
  return maker;
}

BodyProperties drawn_material(const std::string& object_id, int particle, std::uint64_t seed) {
  if (particle == 0) return {};
  std::seed_seq seeds{seed, seed >> 32, hash(object_id), hash(object_id) >> 32, static_cast<std::uint64_t>(particle)};
  std::mt19937_64 random(seeds);
  BodyProperties properties;
  properties.friction = uniform(random, kMinFriction, kMaxFriction);
  properties.restitution = uniform(random, kMinRestitution, kMaxRestitution);
  return properties;
}

Candidate in_world_of(int particle, std::uint64_t seed, const Candidate& candidate,
                      const std::vector<ObjectState>& scene) {
  Candidate drawn = candidate;
  for (const ObjectState& object : scene) {
    if (particle == 0 || object.mode != MotionMode::kDynamic || contains(candidate.removed_ids, object.id)) continue;
    const BodyProperties material = drawn_material(object.id, particle, seed);
    BodyProperties& given = change_of(object.id, drawn).properties;
    if (!object.properties.friction && !given.friction) given.friction = material.friction;
    if (!object.properties.restitution && !given.restitution) given.restitution = material.restitution;
  }
  return drawn;
}

std::vector<Candidate> in_all_worlds(const std::vector<Candidate>& candidates, const std::vector<ObjectState>& scene,
                                     const RolloutOptions& rollout) {
  std::vector<Candidate> all;
  for (const Candidate& candidate : candidates) {
    for (int particle = 0; particle < rollout.num_particles; ++particle) {
      all.push_back(in_world_of(particle, rollout.particle_seed, candidate, scene));
    }
  }
  return all;
}

}  // namespace rigidformer
