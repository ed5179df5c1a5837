// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "rigidformer/tracking/observation.hpp"
#include "rigidformer/tracking/options.hpp"

namespace rigidformer {

struct CloudRegistration;

/// What became of an observation.
enum class AddResult {
  kExtended,       ///< Continued its track
  kLowQuality,     ///< Likewise, but the cloud fits no pose well
  kNewTrack,       ///< Began a track
  kTimeRestarted,  ///< Stamp far in the past: everything was cleared, then a track begun
  kLate,           ///< Slightly older than the newest: dropped
  kTooFewPoints,   ///< Dropped
  kNoPose,         ///< Dropped: correspondence is by pose and there is none
};

/// Keeps one track per object id: a reference cloud and the poses since it began. Knows time by stamps only. Objects
/// that no model can predict are skipped in every scene and have no say in its time, so that the others are seen as if
/// they were not there. Not thread safe.
class TrackStore {
 public:
  explicit TrackStore(const TrackingOptions& options);
  ~TrackStore();
  TrackStore(TrackStore&&) noexcept;
  TrackStore& operator=(TrackStore&&) noexcept;

  AddResult add(const ObjectObservation& observation);

  /// The newest scene that all current objects share; empty store = empty scene with stamp 0.
  ObservedScene snapshot(double time_step_s) const;

  /// Why this object is skipped in every scene, with what is known of it now; empty = it is not, or there is none.
  std::optional<std::string> objection_to(const std::string& id) const;

  TrackRecords records() const;

  void clear();
  bool empty() const { return tracks_.empty(); }

 private:
  struct Track;
  enum class TimeRank { kUnusable, kStatic, kMoving };  ///< Whose clouds tell what time it is: the highest ones'

  AddResult begin_track(const ObjectObservation& observation, const std::vector<int>& seen_rows);
  AddResult extend_track(Track& track, const ObjectObservation& observation, const std::vector<int>& seen_rows);
  std::optional<CloudRegistration> match_rows(const Track& track, const ObjectObservation& observation,
                                              const std::vector<int>& seen_rows) const;
  std::optional<CloudRegistration> follow(Track& track, const ObjectObservation& observation,
                                          const std::vector<int>& seen_rows) const;
  double seconds_since(const Track& track, Stamp stamp) const;
  bool is_too_fast(const Track& track, Stamp stamp, const RigidTransform& T_world_object) const;
  AddResult taken_in(Track& track, AddResult result);
  void forget_unseen();
  bool is_ordered() const { return options_.correspondence.method == Correspondence::kOrdered; }
  Stamp newest_stamp(TimeRank highest) const;
  Stamp common_stamp(Stamp newest) const;
  ObservedObject observe(const std::string& id, const Track& track, Stamp stamp, double time_step_s) const;

  TrackingOptions options_;
  std::map<std::string, std::unique_ptr<Track>> tracks_;  ///< By object id
  std::uint64_t num_tracks_begun_ = 0;
};

}  // namespace rigidformer
