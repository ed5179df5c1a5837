// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/network_rollout.hpp"

#include <chrono>
#include <utility>

#include "rigidformer/particles.hpp"

namespace rigidformer {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

NetworkRollout::NetworkRollout(const StepMaker& maker, const torch::Device& device, int max_points,
                               const std::vector<ObjectState>& objects, const RolloutOptions& rollout)
    : doubt_(maker.doubt) {
  const auto start = std::chrono::steady_clock::now();
  c10::InferenceMode inference;
  RigidFormer model = maker.model;
  const PerceivedObjects perceived = perceive(model, device, max_points, objects, rollout);
  const auto world_of = [&](const StepMaker& steps, const Candidate& candidate, Forecast& forecast) {
    return std::make_unique<RolloutWorld>(steps, perceived, candidate_objects(candidate, objects, rollout.time_step_s),
                                          rollout, forecast);
  };
  world_ = world_of(maker, {}, forecast_);
  const StepMaker particle_maker = maker_of_particles(maker);
  for (int p = 0; doubt_ && rollout.num_particles > 1 && p < rollout.num_particles; ++p) {
    particles_.push_back(std::make_unique<Particle>());
    particles_.back()->world =
        world_of(particle_maker, in_world_of(p, rollout.particle_seed, {}, objects), particles_.back()->forecast);
  }
  for (const ObjectState& object : objects) modes_.push_back(object.mode);
  forecast_.compute_time_s = seconds_since(start);
}

std::optional<Doubt> NetworkRollout::spread(std::size_t object, std::size_t step) const {
  if (particles_.empty()) return {};
  std::vector<RigidTransform> poses;
  for (const auto& particle : particles_) poses.push_back(particle->forecast.objects[object].poses[step]);
  return spread_of(poses);
}

const Forecast& NetworkRollout::advance(int num_steps) {
  const auto start = std::chrono::steady_clock::now();
  c10::InferenceMode inference;
  for (int i = 0; i < num_steps; ++i) {
    world_->step();
    for (const auto& particle : particles_) particle->world->step();
  }
  if (doubt_) {
    const Spread spread_at = [this](std::size_t object, std::size_t step) { return spread(object, step); };
    add_doubt(*doubt_, world_->knowledge(), modes_, spread_at, forecast_);
  }
  forecast_.compute_time_s += seconds_since(start);
  return forecast_;
}

}  // namespace rigidformer
