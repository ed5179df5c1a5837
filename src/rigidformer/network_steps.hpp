// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "rigidformer/perceived_objects.hpp"
#include "rigidformer/step_parts.hpp"
#include "rigidformer/world_contacts.hpp"

namespace rigidformer {

/// Some objects of a scene with all that a step of the network on them needs.
class NetworkView {
 public:
  /// The rows `rows` of a scene that has its solids in their roles.
  NetworkView(RigidFormer model, const PerceivedObjects& scene, std::vector<std::int64_t> rows);
  NetworkView(const NetworkView&) = delete;
  NetworkView& operator=(const NetworkView&) = delete;

  const std::vector<std::int64_t>& rows() const { return rows_; }

  /// The next poses of these objects, in a state of the whole scene `scene`.
  StepPrediction step(const SceneBatch& scene, const SceneState& state);

  /// Of the last step, with the indices of the whole scene.
  const std::vector<PressedPair>& pressed() const { return pressed_; }
  const std::vector<ObjectPair>& met() const { return met_; }

 private:
  std::int64_t in_scene(std::int64_t k) const { return k < 0 ? k : rows_[static_cast<std::size_t>(k)]; }
  EngineStep watched(EngineStep step);
  ContactSearch watched(ContactSearch search);
  Tensor of_rows(const Tensor& scene_values) const;
  Pose of_rows(const Pose& pose) const;

  RigidFormer model_;
  std::vector<std::int64_t> rows_;
  PerceivedObjects objects_;
  Tensor row_index_;  ///< [rows]; undefined = the scene as it is
  NearestSearch nearest_;
  EngineStep engine_;
  ContactSearch contacts_;
  std::vector<PressedPair> pressed_;
  std::vector<ObjectPair> met_;
};

/// The steps that a network takes in one scene, each with those objects that take part in it.
class NetworkSteps {
 public:
  /// `scene` has its solids in their roles; it must outlive this.
  NetworkSteps(RigidFormer model, const PerceivedObjects& scene);

  /// The next poses of all objects; what may not move stays where it is. Where everybody takes part, this is the
  /// network's step on the whole scene.
  StepPrediction predict(const SceneState& state, const StepParts& parts);

  /// What the engine let press on each other, and what free motion brings together; pairs of those that may not move
  /// are the same as in the step before.
  const std::vector<PressedPair>& pressed() const { return pressed_; }
  const std::vector<ObjectPair>& met() const { return met_; }

 private:
  NetworkView& view_of(const std::vector<std::int64_t>& rows);
  void remember(const NetworkView& view, const std::vector<bool>& may_move);

  RigidFormer model_;
  const PerceivedObjects& scene_;
  std::unique_ptr<NetworkView> whole_, part_;  ///< The part is made anew when other objects take part
  std::vector<PressedPair> pressed_;
  std::vector<ObjectPair> met_;
};

}  // namespace rigidformer
