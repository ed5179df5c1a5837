// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "rigidformer/candidates.hpp"
#include "rigidformer/model/doubt_table.hpp"

namespace rigidformer {

/// Candidates whose doubt is known from worlds that differ in what is unknown. The forecasts are those of `nominal`,
/// the engine's steps tell how far worlds part from each other.
class ParticleBatch : public BatchRollout {
 public:
  /// `particles` holds the worlds 0 ... `num_particles` - 1 of the first candidate, then those of the next one.
  ParticleBatch(std::unique_ptr<BatchRollout> nominal, std::unique_ptr<BatchRollout> particles,
                const BatchOptions& options, std::optional<DoubtTable> table);

  /// The forecasts first, then the particles: whoever runs out of time has the forecasts.
  bool advance(double budget_s) override;
  const std::vector<CandidateOutcome>& outcomes() const override { return outcomes_; }
  const std::vector<ObjectTrajectory>& unusable() const override { return nominal_->unusable(); }

 private:
  const CandidateOutcome& particle(std::size_t candidate, std::size_t number) const;
  bool all_done(std::size_t candidate) const;
  void conclude(std::size_t candidate);
  std::vector<RigidTransform> poses_at(std::size_t candidate, std::size_t object, std::size_t step) const;
  ParticleOutcome outcome_of(const CandidateOutcome& particle, const CandidateOutcome& centre, std::size_t object,
                             const RigidTransform& T_world_end) const;

  std::unique_ptr<BatchRollout> nominal_, particles_;
  BatchOptions options_;
  std::optional<DoubtTable> table_;
  std::size_t num_particles_;
  std::vector<CandidateOutcome> outcomes_;
};

}  // namespace rigidformer
