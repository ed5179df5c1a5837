// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rigidformer/rollout_world.hpp"

namespace rigidformer {

/// Perceives objects of which at least one is there, all usable; throws BodyError.
using Perceive = std::function<PerceivedObjects(const std::vector<ObjectState>& objects)>;

/// Candidates of one perceived scene. Every candidate is stepped by itself, as a batch of one scene: a library's matrix
/// product may round a row otherwise when others stand beside it, and a candidate's numbers must not depend on others.
class CandidateBatch : public BatchRollout {
 public:
  /// `scene` is the perception of the objects `states`; `unusable` are those that are left out.
  CandidateBatch(const StepMaker& maker, const Perceive& perceive, PerceivedObjects scene,
                 std::vector<ObjectState> states, std::vector<ObjectTrajectory> unusable,
                 const std::vector<Candidate>& candidates, const BatchOptions& options, int max_objects);

  bool advance(double budget_s) override;
  const std::vector<CandidateOutcome>& outcomes() const override { return outcomes_; }
  const std::vector<ObjectTrajectory>& unusable() const override { return unusable_; }

 private:
  using Clock = std::chrono::steady_clock;

  /// A candidate in progress.
  struct Running {
    std::vector<CandidateObject> objects;                      ///< Until its world is made
    std::vector<std::shared_ptr<const PerceivedObjects>> own;  ///< Perceptions of the bodies that only tracks know
    std::unique_ptr<RolloutWorld> world;
  };

  void prepare(const Candidate& candidate, const Perceive& perceive, int max_objects, std::size_t i);
  std::shared_ptr<const PerceivedObjects> perceived_body(const Perceive& perceive, const ObjectState& body);
  std::string reason_for(const std::string& message) const;
  std::vector<std::size_t> next_level() const;
  void advance_level(const std::vector<std::size_t>& level, Clock::time_point limit);
  void advance_one(std::size_t i);
  void take_step(std::size_t i);
  void refuse(std::size_t i, CandidateOutcome::Error error, const std::string& message);
  void end_where_due(std::size_t i);
  int steps_done(std::size_t i) const;

  StepMaker maker_;
  BatchOptions options_;
  PerceivedObjects scene_;
  std::vector<ObjectState> states_;
  std::vector<ObjectTrajectory> unusable_;
  std::vector<std::pair<Points, std::shared_ptr<const PerceivedObjects>>> bodies_;  ///< Perceived bodies of tracks
  std::vector<Running> running_;
  std::vector<CandidateOutcome> outcomes_;
};

}  // namespace rigidformer
