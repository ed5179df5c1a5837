// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/tracking/stamp.hpp"

namespace rigidformer {

/// An object's observed poses over time, oldest first, bounded in number.
class PoseHistory {
 public:
  /// A pose closer than `min_dt_s` to the start of the newest entry replaces that entry, a later one is appended.
  /// `stamp` must not lie before newest_stamp().
  void add(Stamp stamp, const RigidTransform& T_world_object, double min_dt_s);

  /// Pose at `stamp`: between entries the position is interpolated by a parabola through three of them (exact for free
  /// fall), or linearly where only two serve, and the rotation by slerp. Extrapolates by at most one frame, in either
  /// direction. Empty when that does not reach the instant, or for any other instant of a history with a single pose.
  std::optional<RigidTransform> pose_at(Stamp stamp) const { return pose_before(stamp, 0.0); }

  /// Pose `seconds` before `stamp` (an instant between the nanoseconds of a stamp).
  std::optional<RigidTransform> pose_before(Stamp stamp, double seconds) const;

  /// Pose at `stamp`, however far after newest_stamp(), if the twist of the last frames stayed constant; the newest
  /// pose where there is no other. The history must not be empty.
  RigidTransform predict(Stamp stamp) const;

  Stamp newest_stamp() const { return entries_.back().stamp; }
  const RigidTransform& newest_pose() const { return entries_.back().T_world_object; }
  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    Stamp first_stamp;  ///< Of the first pose this entry held
    Stamp stamp;
    RigidTransform T_world_object;
  };

  /// Seconds from entry `reference` to entry `index`.
  double spacing_s(std::size_t reference, std::size_t index) const;
  Eigen::Vector3d position_at(std::size_t segment, double seconds_into_segment) const;

  std::deque<Entry> entries_;
};

}  // namespace rigidformer
