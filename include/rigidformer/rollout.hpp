// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// Predicted motion of one object. `poses[k]` is T_world_reference at `Forecast::times_s[k]`; k = 0 is the observation.
struct ObjectTrajectory {
  enum class Status {
    kOk,
    kDiverged,  ///< The prediction stopped being finite: it keeps its last finite pose
    kUnusable   ///< It took no part, the others were predicted as if it were not there: it stays where it was observed
  };
  std::string id;
  Status status = Status::kOk;
  std::vector<RigidTransform> poses;
  std::string reason = {};  ///< Of kUnusable
};

/// Predicted motion of a scene.
struct Forecast {
  std::vector<double> times_s;            ///< times_s[0] = 0, then in steps of the time step
  std::vector<ObjectTrajectory> objects;  ///< Objects in the order of the input
  double compute_time_s = 0.0;
};

/// A rollout under way, for callers that want to look in between: advancing by 8 and then by 16 steps gives what 24 at
/// once give. The predictor that began it must outlive it.
class Rollout {
 public:
  virtual ~Rollout() = default;

  /// Predicts `num_steps` more steps and returns everything from the observation on. The forecast's compute
  /// time is that of all steps so far.
  virtual const Forecast& advance(int num_steps) = 0;
};

}  // namespace rigidformer
