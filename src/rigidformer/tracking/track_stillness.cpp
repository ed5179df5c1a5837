// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How long a TrackStore's objects were seen not to move.
#include "rigidformer/tracking/track.hpp"

namespace rigidformer {

// After a gap, for example, a new track may begin where the old one saw its object lie.
Stillness TrackStore::stillness_before(const ObjectObservation& observation, const std::vector<int>& seen_rows) {
  const auto found = tracks_.find(observation.id);
  if (found == tracks_.end() || found->second->is_static()) return {};
  Track& old = *found->second;
  std::optional<RigidTransform> T_world_object = observation.T_world_object;
  if (!T_world_object && is_ordered()) {
    const auto match = match_rows(old, observation, seen_rows);
    if (match && match->objection.empty()) T_world_object = match->T_world_object;
  } else if (!T_world_object &&
             old.tracker->lies_at(select_rows(observation.points_world, seen_rows), old.poses.newest_pose())) {
    T_world_object = old.poses.newest_pose();
  }
  if (!T_world_object) return {};
  old.poses.add(observation.stamp, *T_world_object, options_.history.min_dt);
  return stillness_of(old);
}

Stillness TrackStore::stillness_of(const Track& track) const {
  return seen_still(track.poses, track.known_points(), track.before, options_.correspondence.noise);
}

}  // namespace rigidformer
