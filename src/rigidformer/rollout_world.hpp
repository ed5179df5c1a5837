// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "rigidformer/candidate_objects.hpp"
#include "rigidformer/doubt.hpp"
#include "rigidformer/engine/body_motion.hpp"
#include "rigidformer/model/rest.hpp"
#include "rigidformer/network_steps.hpp"
#include "rigidformer/perceived_objects.hpp"
#include "rigidformer/standing.hpp"
#include "rigidformer/step_parts.hpp"
#include "rigidformer/world_contacts.hpp"

namespace rigidformer {

/// What takes the steps of a rollout.
struct StepMaker {
  RigidFormer model;
  RestLimits rest;
  Fidelity fidelity = Fidelity::kModel;
  std::optional<DoubtTable> doubt = {};  ///< Of the model
};

/// One scene on its way through the network (paper §3) or the engine, with a world of its own: it is never restored to
/// an earlier state, and nothing in it depends on other scenes. Worlds of one perception may be stepped in several
/// threads at once.
class RolloutWorld {
 public:
  /// `perceived` holds exactly `objects`, in that order. Writes the observation and all steps to `forecast`, which is
  /// empty at first. Throws CandidateError.
  RolloutWorld(const StepMaker& maker, PerceivedObjects perceived, std::vector<CandidateObject> objects,
               const RolloutOptions& rollout, Forecast& forecast);
  RolloutWorld(const RolloutWorld&) = delete;
  RolloutWorld& operator=(const RolloutWorld&) = delete;

  void step();

  std::vector<Knowledge> knowledge() const { return knowledge_of(objects_, perceived_.solids); }

  /// Indices of the objects that the network saw in the last step.
  const std::vector<std::int64_t>& seen() const { return parts_.seen; }

 private:
  void assume_roles();
  void make_steps();
  void check_overlaps() const;
  void stand();
  void set_twists();
  BodyPoses body_poses() const;
  void set_motion(std::size_t k, const BodyPoses& poses, const BodyState& motion);
  void push();
  void set_coming();
  std::vector<bool> moved_by_others() const;
  StepParts find_parts(const std::vector<bool>& moved);
  StepPrediction predict(const std::vector<bool>& moved);
  void hold_standing(const std::vector<bool>& moved, SceneState& next);
  void record(SceneState& next);
  void freeze(SceneState& next, std::int64_t k);
  void record_contacts();
  void settle_pushed(const SceneState& next);
  bool stays(const SceneState& next) const;
  void repeat();
  int steps_done() const { return static_cast<int>(forecast_.times_s.size()) - 1; }

  StepMaker maker_;
  RolloutOptions rollout_;
  PerceivedObjects perceived_;
  std::vector<CandidateObject> objects_;
  SolidScene solids_;
  SceneState state_;
  EngineStep engine_;                      ///< Where the engine answers alone
  std::unique_ptr<NetworkSteps> network_;  ///< Where it does not
  Standing standing_;
  Sleepers sleepers_;
  StepParts parts_;           ///< Of the last step of the network
  std::vector<bool> pushed_;  ///< Set in motion by a twist or a push, and not at rest since
  std::vector<PressedPair> pressed_;
  std::vector<ObjectPair> met_;  ///< That free motion brings together during the step
  bool is_over_ = false;         ///< Nothing will change any more
  Forecast& forecast_;
};

}  // namespace rigidformer
