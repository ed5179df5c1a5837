// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/particle_batch.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "rigidformer/doubt.hpp"

namespace rigidformer {
namespace {

using Stop = CandidateOutcome::Stop;
using Clock = std::chrono::steady_clock;

const RigidTransform& pose_of(const CandidateOutcome& outcome, std::size_t object, std::size_t step) {
  const auto& poses = outcome.forecast.objects[object].poses;
  return poses[std::min(step, poses.size() - 1)];
}

/// Where the forecast would end if it parted from its own world as the particle does from the engine's.
RigidTransform moved_along(const RigidTransform& end, const RigidTransform& particle, const RigidTransform& centre) {
  return {(particle.rotation * centre.rotation.conjugate() * end.rotation).normalized(),
          end.translation + particle.translation - centre.translation};
}

}  // namespace

ParticleBatch::ParticleBatch(std::unique_ptr<BatchRollout> nominal, std::unique_ptr<BatchRollout> particles,
                             const BatchOptions& options, std::optional<DoubtTable> table)
    : nominal_(std::move(nominal)),
      particles_(std::move(particles)),
      options_(options),
      table_(std::move(table)),
      num_particles_(static_cast<std::size_t>(options.rollout.num_particles)),
      outcomes_(nominal_->outcomes()) {}

const CandidateOutcome& ParticleBatch::particle(std::size_t candidate, std::size_t number) const {
  return particles_->outcomes()[candidate * num_particles_ + number];
}

bool ParticleBatch::advance(double budget_s) {
  const Clock::time_point start = Clock::now();
  bool is_running = nominal_->advance(budget_s);
  const double left_s = budget_s - std::chrono::duration<double>(Clock::now() - start).count();
  if (!is_running && left_s > 0.0) is_running = particles_->advance(left_s);
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    if (outcomes_[i].stop != Stop::kRunning) continue;
    outcomes_[i] = nominal_->outcomes()[i];
    if (outcomes_[i].stop == Stop::kRunning || outcomes_[i].stop == Stop::kRefused) continue;
    if (all_done(i)) {
      conclude(i);
    } else {
      outcomes_[i].stop = Stop::kRunning;
      is_running = true;
    }
  }
  return is_running;
}

bool ParticleBatch::all_done(std::size_t candidate) const {
  for (std::size_t p = 0; p < num_particles_; ++p) {
    if (particle(candidate, p).stop == Stop::kRunning) return false;
  }
  return true;
}

/// Poses of an object in all worlds at that step, or at the end of those that ended before.
std::vector<RigidTransform> ParticleBatch::poses_at(std::size_t candidate, std::size_t object, std::size_t step) const {
  std::vector<RigidTransform> poses;
  for (std::size_t p = 0; p < num_particles_; ++p) {
    if (particle(candidate, p).stop == Stop::kRefused) continue;
    poses.push_back(pose_of(particle(candidate, p), object, step));
  }
  return poses;
}

ParticleOutcome ParticleBatch::outcome_of(const CandidateOutcome& particle, const CandidateOutcome& centre,
                                          std::size_t object, const RigidTransform& T_world_end) const {
  const auto& poses = particle.forecast.objects[object].poses;
  ParticleOutcome outcome;
  outcome.T_world_end = moved_along(T_world_end, poses.back(), centre.forecast.objects[object].poses.back());
  outcome.has_settled = settled_step(poses, options_.rollout.time_step_s, options_.settle) >= 0;
  outcome.max_tilt_rad = max_tilt(poses);
  return outcome;
}

void ParticleBatch::conclude(std::size_t candidate) {
  CandidateOutcome& outcome = outcomes_[candidate];
  const CandidateOutcome& centre = particle(candidate, 0);
  if (centre.stop == Stop::kRefused) return;
  for (std::size_t k = 0; k < outcome.forecast.objects.size(); ++k) {
    outcome.particles.emplace_back();
    for (std::size_t p = 0; p < num_particles_; ++p) {
      if (particle(candidate, p).stop == Stop::kRefused) continue;
      outcome.particles.back().push_back(
          outcome_of(particle(candidate, p), centre, k, outcome.forecast.objects[k].poses.back()));
    }
  }
  if (!table_ || options_.fidelity == Fidelity::kEngine) return;
  for (ObjectTrajectory& object : outcome.forecast.objects) object.position_stddev_m = object.rotation_stddev_rad = {};
  const Spread spread = [&](std::size_t object, std::size_t step) -> std::optional<Doubt> {
    const std::vector<RigidTransform> poses = poses_at(candidate, object, step);
    return poses.size() < 2 ? std::nullopt : std::make_optional(spread_of(poses));
  };
  add_doubt(*table_, outcome.knowledge, outcome.modes, spread, outcome.forecast);
}

}  // namespace rigidformer
