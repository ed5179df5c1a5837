// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "rigidformer/engine/solid_scene.hpp"
#include "rigidformer/world_contacts.hpp"

namespace rigidformer {

/// Which of the observed objects were seen not to move for so long that something carries them, whatever their hulls
/// say: gravity pulled at them all the time. Where nothing is seen below an object, that takes longer. Poses have their
/// origin in the centre of mass.
std::vector<bool> who_stands(const std::vector<ObjectState>& objects, const SolidScene& scene,
                             const std::vector<RigidTransform>& T_world_body);

/// What was seen to stand, and goes on standing until something that moves touches it or what carries it moves.
class Standing {
 public:
  Standing() = default;
  /// `stands` [K] of the bodies in these poses, which have their origin in the centre of mass.
  Standing(const SolidScene& scene, const std::vector<RigidTransform>& T_world_body, std::vector<bool> stands);

  bool any() const;
  /// [K] that still stand.
  const std::vector<bool>& who() const { return stands_; }

  /// Lets go of all that a step does not leave alone. `moves` [K]: would be elsewhere after the step, with what stands
  /// left to model and engine; `touching` is asked for the pairs that meet in the step only if somebody moves.
  void let_go(const std::vector<bool>& moves, const std::function<std::vector<ObjectPair>()>& touching);
  void let_go(std::size_t k) { stands_[k] = false; }

 private:
  bool may_hit(std::size_t moving, std::size_t standing) const;

  std::vector<bool> stands_, stood_;                   ///< Now, and at the start
  std::vector<std::vector<std::size_t>> carriers_;     ///< Of each body: those that it lies on
  std::vector<std::vector<std::size_t>> overlapping_;  ///< Of each body: those whose hull reaches into its own
};

/// What a candidate takes away, moves or sets in motion may have carried what touches it: that does not stand any more.
/// `objects` are those of the candidate; `solids` and `states` are what was observed.
void forget_lost_support(const std::vector<ObservedSolid>& solids, const std::vector<ObjectState>& states,
                         std::vector<CandidateObject>& objects);

}  // namespace rigidformer
