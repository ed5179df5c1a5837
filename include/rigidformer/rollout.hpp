// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
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
  /// One per pose, empty = unknown: of each coordinate of the position [m] and of the rotation vector [rad].
  std::vector<double> position_stddev_m = {}, rotation_stddev_rad = {};
};

/// Two objects that touch at the end of a step, or pressed on each other during it. Objects are numbered as in the
/// forecast.
struct StepContact {
  int step = 0;  ///< 0 = the observation
  int object_a = 0;
  int object_b = -1;           ///< -1 = the ground
  double penetration_m = 0.0;  ///< How deep the shapes reach into each other at the end of the step
  double normal_impulse_Ns =
      std::numeric_limits<double>::quiet_NaN();  ///< Of the step; NaN = masses unknown, or a model without an engine
};

/// Predicted motion of a scene.
struct Forecast {
  std::vector<double> times_s;            ///< times_s[0] = 0, then in steps of the time step
  std::vector<ObjectTrajectory> objects;  ///< Objects in the order of the input
  double compute_time_s = 0.0;
  std::vector<StepContact> contacts = {};  ///< In the order of the steps; empty where the build has no Bullet
};

/// When an object counts as settled: both speeds stay within these limits for this long. docs/conventions.md has what
/// else is said of what moves little.
struct SettleCriterion {
  double linear_speed_mps = 0.02;  ///< Largest speed of the origin [m/s]
  double angular_speed_rps = 0.1;  ///< Largest angular speed [rad/s]
  double duration_s = 0.25;        ///< Shortest time at rest [s]
};

/// The first step from which the object stays at rest up to the last pose. The result is -1 when it moves at the end,
/// or when its rest is shorter than the criterion asks for.
int settled_step(const std::vector<RigidTransform>& poses, double time_step_s, const SettleCriterion& criterion);

/// The first step at whose end, or during which, object number `object` touches something; -1 = never.
int first_contact_step(const Forecast& forecast, int object);

/// All that two bodies had to do with each other during a forecast.
struct ContactSpan {
  int object_a = 0;
  int object_b = -1;                   ///< -1 = the ground
  int first_step = 0, last_step = 0;   ///< In between they may have parted
  double max_penetration_m = 0.0;      ///< The deepest of all steps
  double max_normal_impulse_Ns = 0.0;  ///< The largest of one step; NaN = unknown
};
std::vector<ContactSpan> contact_spans(const Forecast& forecast);

/// Largest angle [rad] by which what was up in the first pose leaves the vertical; turning about it is no tilt.
double max_tilt(const std::vector<RigidTransform>& poses);

/// Length [m] of the path of the origin.
double path_length(const std::vector<RigidTransform>& poses);

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
