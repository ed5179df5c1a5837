// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rigidformer/tracking/observation.hpp"
#include "rigidformer/tracking/options.hpp"

namespace rigidformer {

struct CloudRegistration;
struct Sighting;
enum class Presence;

/// What became of an observation.
enum class AddResult {
  kExtended,    ///< It continued its track.
  kLowQuality,  ///< It continued its track, but the cloud fits no pose well.
  kNewTrack,    ///< It began a track.
  /// It began a track, because the last cloud of its object is too long ago to tell a velocity.
  kNewTrackAfterGap,
  kTimeRestarted,  ///< Its stamp lies far in the past: everything was cleared, and it began a track.
  kLate,           ///< It is slightly older than the newest one and was dropped.
  kTooFewPoints,   ///< It has too few points and was dropped.
  kNoPose,         ///< It has no pose although correspondence is by pose, and was dropped.
};

/// Keeps one track per object id: a reference cloud and the poses since the track began. Stamps and arrivals of the
/// observations are the only clocks. Objects that no model can predict are skipped in every scene and have no say in
/// its instant, so that the others are seen as if they were not there. Not thread safe.
class TrackStore {
 public:
  explicit TrackStore(const TrackingOptions& options);
  ~TrackStore();
  TrackStore(TrackStore&&) noexcept;
  TrackStore& operator=(TrackStore&&) noexcept;

  AddResult add(const ObjectObservation& observation);

  /// The newest scene that all current objects share. An empty store gives an empty scene with stamp 0.
  ObservedScene snapshot(double time_step_s) const;

  /// Why this object is skipped in every scene, with what is known of it now; empty = it is not, or there is none.
  std::optional<std::string> objection_to(const std::string& id) const;

  TrackRecords records() const;

  /// Stamp of the newest cloud of an object; empty = it is not tracked.
  std::optional<Stamp> newest_stamp_of(const std::string& id) const;

  void clear();
  bool empty() const { return tracks_.empty(); }

 private:
  struct Track;

  AddResult begin_track(const ObjectObservation& observation, const std::vector<int>& seen_rows);
  AddResult extend_track(Track& track, const ObjectObservation& observation, const std::vector<int>& seen_rows);
  Stillness stillness_before(const ObjectObservation& observation, const std::vector<int>& seen_rows);
  Stillness stillness_of(const Track& track) const;
  std::optional<CloudRegistration> match_rows(const Track& track, const ObjectObservation& observation,
                                              const std::vector<int>& seen_rows) const;
  std::optional<CloudRegistration> follow(Track& track, const ObjectObservation& observation,
                                          const std::vector<int>& seen_rows) const;
  double seconds_since(const Track& track, Stamp stamp) const;
  bool is_too_fast(const Track& track, Stamp stamp, const RigidTransform& T_world_object) const;
  AddResult taken_in(Track& track, AddResult result);
  void forget_unseen();
  bool is_ordered() const { return options_.correspondence.method == Correspondence::kOrdered; }
  std::vector<Sighting> sightings() const;
  Stamp newest_arrival() const;
  void add_moving(ObservedScene& scene, const std::string& id, const Track& track, Presence presence) const;
  ObservedObject observe(const std::string& id, const Track& track, Stamp stamp, double time_step_s) const;

  TrackingOptions options_;
  std::map<std::string, std::unique_ptr<Track>> tracks_;  ///< The tracks by object id
  std::uint64_t num_tracks_begun_ = 0;
};

}  // namespace rigidformer
