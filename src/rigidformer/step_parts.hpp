// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/engine/body_motion.hpp"
#include "rigidformer/model/batch.hpp"

namespace rigidformer {

/// Who takes part in a step of a scene of K objects.
struct StepParts {
  std::vector<bool> may_move;      ///< [K] Awake, or may be reached within the step, be it over others; else it stays
  std::vector<std::int64_t> seen;  ///< Indices of these and of what stands so near that their motion may hang on it

  bool is_everybody() const;
};

StepParts everybody(std::size_t num_objects);

/// Tells who sleeps in a rollout whose resting objects are held (rest.hpp): whoever was stepped from where it is, was
/// put back since, and would be put back again.
class Sleepers {
 public:
  /// [K], to be called once before every step. Nobody sleeps in the first one. Objects whose motion is given sleep as
  /// well: whoever calls keeps those awake that move, and whatever else must not sleep.
  std::vector<bool> find(const SceneBatch& batch, const SceneState& state);

 private:
  Pose stepped_;  ///< From which the last step was taken
};

/// The parts of a step in which some bodies sleep, with poses as in BodyPoses and those to which given motion comes.
StepParts find_parts(const SolidScene& scene, const BodyPoses& poses, const std::vector<RigidTransform>& coming,
                     const std::vector<bool>& asleep);

}  // namespace rigidformer
