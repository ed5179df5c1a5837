// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "rigidformer/rollout.hpp"
#include "rigidformer/scene/object.hpp"
#include "rigidformer/scene/rollout_options.hpp"

/// "What if": one observed scene, rolled out many times with changes. Nobody but the planner rates the outcomes.
namespace rigidformer {

/// Velocity at one instant, along the axes of the world.
struct Twist {
  Eigen::Vector3d linear_mps = Eigen::Vector3d::Zero();   ///< Of the reference frame's origin
  Eigen::Vector3d angular_rps = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// Replaces parts of an object's state at t0; what is empty stays as observed.
struct StateChange {
  std::string id;
  std::optional<RigidTransform> T_world_reference;
  std::optional<Twist> twist;      ///< At t0. A pose that is replaced keeps the observed twist without it
  std::optional<MotionMode> mode;  ///< An object that becomes static stands still
  BodyProperties properties = {};  ///< Those that are known here replace the object's
};

/// A push on a dynamic object whose mass is known. It acts at the beginning of the first step that ends after its time.
struct Push {
  std::string id;
  double time_s = 0.0;                                        ///< From t0, not negative
  Eigen::Vector3d linear_Ns = Eigen::Vector3d::Zero();        ///< Impulse along the axes of the world
  Eigen::Vector3d angular_Nms = Eigen::Vector3d::Zero();      ///< Angular impulse beside it
  Eigen::Vector3d point_reference = Eigen::Vector3d::Zero();  ///< [m] where `linear_Ns` acts, in the reference frame
};

/// Given motion of a body: linear between poses and by slerp, at the first pose before, at the last one after.
struct GivenTrack {
  std::string id;
  Points points_reference = {};      ///< [N, 3] m of a body that nobody observes; empty = the observed object `id`
  BodyProperties properties = {};    ///< Of that body
  std::vector<double> times_s = {};  ///< Strictly increasing, from t0; may begin before it
  std::vector<RigidTransform> T_world_reference = {};  ///< One per time
  double max_speed_mps = 0.0;                          ///< A track whose origin is faster is refused; 0 = unchecked
};

/// Changes to a scene in the order in which they are made: removal, changes of states, tracks; pushes come in time.
struct Candidate {
  std::string name;
  std::vector<std::string> removed_ids = {};
  std::vector<StateChange> changes = {};
  std::vector<Push> pushes = {};
  std::vector<GivenTrack> tracks = {};
};

/// An axis-parallel box of its own frame: an object is inside when the origin of its reference frame is.
struct BoxRegion {
  std::string name;
  RigidTransform T_world_box;  ///< The centre of the box
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();

  bool contains(const Eigen::Vector3d& point_world) const;
};

/// What ends a candidate before the horizon.
struct StopRule {
  enum class Kind {
    kTouch,      ///< One of the objects touches what it did not touch at t0
    kTilt,       ///< One of the objects tilts by more than `value` [rad] (see max_tilt())
    kLeave,      ///< One of the objects is outside of `region`
    kAllSettled  ///< All of the objects have settled
  };
  Kind kind = Kind::kAllSettled;
  std::vector<std::string> ids = {};  ///< Empty = all dynamic objects
  double value = 0.0;
  BoxRegion region = {};
};

/// What takes the steps.
enum class Fidelity {
  kModel,  ///< The loaded model, as in Predictor::start()
  kEngine  ///< The physics engine alone, on the shapes and materials that the model sees: for screening
};

/// What holds for all candidates.
struct BatchOptions {
  RolloutOptions rollout;
  Fidelity fidelity = Fidelity::kModel;
  int num_threads = 1;  ///< Candidates in progress at once
  std::vector<StopRule> stop = {};
  SettleCriterion settle = {};
};

/// What came of an object in one of the worlds that differ in what is unknown.
struct ParticleOutcome {
  RigidTransform T_world_end;
  bool has_settled = false;
  double max_tilt_rad = 0.0;
};

/// How one candidate went.
struct CandidateOutcome {
  enum class Stop {
    kRunning,   ///< It has not come to its end yet
    kHorizon,   ///< All steps are done
    kRule,      ///< A StopRule ended it: number `rule`
    kDiverged,  ///< The predictions of all dynamic objects stopped being finite
    kRefused    ///< It is not possible: see `error`
  };
  enum class Error {
    kNone,
    kUnknownObject,  ///< An id that the scene does not have
    kInvalid,        ///< Anything else that cannot be done
    kFailed          ///< A step failed, through no fault of the candidate
  };
  std::string name;
  Stop stop = Stop::kRunning;
  int rule = -1;
  Error error = Error::kNone;
  std::string message;                                  ///< Of the error: object, field and value
  std::vector<MotionMode> modes;                        ///< Of the forecast's objects
  std::vector<Knowledge> knowledge;                     ///< Likewise, once a step was taken
  std::vector<std::vector<ParticleOutcome>> particles;  ///< Of each of the forecast's objects; empty without particles
  Forecast forecast;  ///< The scene's objects without the removed ones, then the bodies that only tracks know
};

/// Candidates of one scene under way. What a candidate comes to depends neither on the others nor on its place among
/// them, nor on the number of threads: it is the same to the byte. The predictor that began it must outlive it.
class BatchRollout {
 public:
  virtual ~BatchRollout() = default;

  /// Takes the next steps, one of every candidate before a second of any, and gives up after `budget_s` seconds, but
  /// not before it has taken a step. Returns whether any candidate is still running.
  virtual bool advance(double budget_s = std::numeric_limits<double>::infinity()) = 0;

  /// In the order of the candidates. They may be read between calls of advance().
  virtual const std::vector<CandidateOutcome>& outcomes() const = 0;

  /// Objects of the scene that took no part in any candidate, each with Status::kUnusable and the reason.
  virtual const std::vector<ObjectTrajectory>& unusable() const = 0;
};

}  // namespace rigidformer
