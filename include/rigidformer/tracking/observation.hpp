// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rigidformer/scene/object.hpp"
#include "rigidformer/tracking/pose_history.hpp"
#include "rigidformer/tracking/stamp.hpp"

namespace rigidformer {

/// One object's cloud at one instant, in the fixed frame. Rows that are not finite count as "not seen".
struct ObjectObservation {
  std::string id;
  Stamp stamp;
  Stamp arrival;        ///< When it came, by the clock of the receiver; zero = at its stamp
  Points points_world;  ///< [N, 3] m
  MotionMode mode = MotionMode::kDynamic;
  BodyProperties properties;
  std::optional<RigidTransform> T_world_object;  ///< Given by a tracker; empty = found from the points
};

/// How well a cloud agrees with the moved reference cloud.
struct RegistrationQuality {
  double rmse_m = 0.0;        ///< Root mean square distance of the inliers from the reference cloud
  double inlier_ratio = 1.0;  ///< Share of the cloud's points that lie on the reference cloud
};

/// An object as its track knows it at the instant of a scene.
struct ObservedObject {
  ObjectState state;            ///< Reference cloud, with the poses at the scene's stamp and one time step earlier
  bool assumed_static = false;  ///< The object was seen too little to know its velocity
  bool low_quality = false;     ///< The newest cloud does not fit a pose well
  RegistrationQuality quality;
  std::uint64_t track = 0;  ///< Number of the track; every new track has another one
};

enum class SkipCause {
  kNotSeen,   ///< Not when the others were
  kUnusable,  ///< There is an objection to it (scene/objection.hpp)
  kSurplus    ///< The model takes fewer objects
};

/// An object that is known, but cannot take part in a scene.
struct SkippedObject {
  std::string id;
  std::string reason;
  SkipCause cause = SkipCause::kNotSeen;
};

/// The scene at `stamp`: each object has its pose then and its pose exactly one time step earlier, ordered by id.
struct ObservedScene {
  Stamp stamp;
  double time_step_s = 0.0;
  std::vector<ObservedObject> objects;
  std::vector<SkippedObject> skipped;
  std::string clock_remark;  ///< What is wrong with the clocks of the sensors; empty = nothing
};

/// Where the object of one track was seen.
struct TrackRecord {
  std::uint64_t track = 0;
  PoseHistory poses;
  bool low_quality = false;  ///< The newest pose is not believed
};

/// Tracks by object id.
using TrackRecords = std::map<std::string, TrackRecord>;

}  // namespace rigidformer
