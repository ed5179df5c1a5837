// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/tracking/stamp.hpp"

namespace rigidformer {

/// How long, and in how many poses, an object was seen not to move.
struct Stillness {
  double seconds = 0.0;
  int num_poses = 0;
};

/// The observed poses of one object over time, oldest first, bounded in number.
class PoseHistory {
 public:
  /// Replaces the newest entry by a pose closer than `min_dt_s` to the start of that entry, and appends a later one.
  /// `stamp` must not lie before newest_stamp().
  void add(Stamp stamp, const RigidTransform& T_world_object, double min_dt_s);

  /// Pose at `stamp`. Between entries the position lies on a parabola through three of them (exact for free fall),
  /// or on a line where only two serve, and the rotation is interpolated by slerp. At most one frame is
  /// extrapolated, in either direction. The answer is empty for an instant beyond that, and for any other instant
  /// of a history with a single pose.
  std::optional<RigidTransform> pose_at(Stamp stamp) const { return pose_before(stamp, 0.0); }

  /// Pose at the instant `seconds` before `stamp`, which may lie between the nanoseconds of a stamp.
  std::optional<RigidTransform> pose_before(Stamp stamp, double seconds) const;

  /// Pose at `stamp`, however far after newest_stamp(), if the twist of the last frames stayed constant; it is the
  /// newest pose where there is no other. The history must not be empty.
  RigidTransform predict(Stamp stamp) const;

  /// The poses up to the newest one, which is one of them, in which the points around `centre` (object frame) up to
  /// `radius_m` lay within `tolerance_m` of where they are in the newest one. The history must not be empty.
  Stillness stillness(const Eigen::Vector3d& centre, double radius_m, double tolerance_m) const;

  Stamp newest_stamp() const { return entries_.back().stamp; }
  const RigidTransform& newest_pose() const { return entries_.back().T_world_object; }
  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    Stamp first_stamp;  ///< Stamp of the first pose that this entry held
    Stamp stamp;
    RigidTransform T_world_object;
  };

  /// Seconds from entry `reference` to entry `index`.
  double spacing_s(std::size_t reference, std::size_t index) const;
  Eigen::Vector3d position_at(std::size_t segment, double seconds_into_segment) const;

  std::deque<Entry> entries_;
};

}  // namespace rigidformer
