// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rigidformer/scene/object.hpp"
#include "rigidformer_ros/cloud_registration.hpp"
#include "rigidformer_ros/cloud_tracker.hpp"
#include "rigidformer_ros/parameters.hpp"
#include "rigidformer_ros/pose_history.hpp"

namespace rigidformer_ros {

using rigidformer::Points;

/// One object's cloud at one instant, in the fixed frame. Rows that are not finite count as "not seen".
struct ObjectObservation {
  std::string id;
  ros::Time stamp;
  Points points_world;  ///< [N, 3] m
  rigidformer::MotionMode mode = rigidformer::MotionMode::kDynamic;
  rigidformer::PhysicalProperties properties;
  std::optional<RigidTransform> T_world_object;  ///< From a tracker; empty = found from the points
};

struct ObservedObject {
  rigidformer::ObjectState state;  ///< Reference points about their centroid
  bool assumed_static = false;     ///< Seen too little to know its velocity
  bool low_quality = false;        ///< The newest cloud does not fit a pose well
  RegistrationQuality quality;
  std::uint64_t track = 0;  ///< Number of its track; every new track has another
};

struct SkippedObject {
  std::string id;
  std::string reason;
};

/// The scene at `stamp`, each object with its pose then and exactly one time step earlier. Objects are ordered by id.
struct ObservedScene {
  ros::Time stamp;
  double time_step_s = 0.0;
  std::vector<ObservedObject> objects;
  std::vector<SkippedObject> skipped;
};

/// Where the object of one track was seen.
struct TrackRecord {
  std::uint64_t track = 0;
  PoseHistory poses;
  bool low_quality = false;  ///< The newest pose
};

/// By object id.
using TrackRecords = std::map<std::string, TrackRecord>;

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

/// Keeps one track per object id: a reference cloud and the poses since it began. Knows time by stamps only.
class TrackStore {
 public:
  TrackStore(const InputParameters& input, const HistoryParameters& history,
             const CorrespondenceParameters& correspondence);

  AddResult add(const ObjectObservation& observation);

  /// The newest scene that all current objects share; empty store = empty scene with stamp 0.
  ObservedScene snapshot(double time_step_s) const;

  TrackRecords records() const;

  void clear() { tracks_.clear(); }
  bool empty() const { return tracks_.empty(); }

 private:
  struct Track {
    std::uint64_t number = 0;
    Points points_reference;              ///< Ordered: all rows, about the centroid of the finite ones
    std::vector<int> rows;                ///< Ordered: finite rows of the reference
    std::optional<CloudTracker> tracker;  ///< Otherwise
    bool frame_is_given = false;          ///< The object frame is that of given poses
    PoseHistory poses;
    RegistrationQuality quality;
    bool low_quality = false;
    rigidformer::MotionMode mode;
    rigidformer::PhysicalProperties properties;
  };

  AddResult begin_track(const ObjectObservation& observation);
  AddResult extend_track(Track& track, const ObjectObservation& observation);
  std::optional<CloudRegistration> match_rows(const Track& track, const ObjectObservation& observation) const;
  std::optional<CloudRegistration> follow(Track& track, const ObjectObservation& observation) const;
  double seconds_since(const Track& track, const ros::Time& stamp) const;
  bool is_too_fast(const Track& track, const ros::Time& stamp, const RigidTransform& T_world_object) const;
  void forget_unseen();
  bool is_ordered() const { return correspondence_.method == "ordered"; }
  bool is_static(const Track& track) const { return track.mode == rigidformer::MotionMode::kStatic; }
  ros::Time newest_stamp() const;
  ros::Time common_stamp(const ros::Time& newest) const;
  ObservedObject observe(const std::string& id, const Track& track, const ros::Time& stamp, double time_step_s) const;

  InputParameters input_;
  HistoryParameters history_;
  CorrespondenceParameters correspondence_;
  std::map<std::string, Track> tracks_;
  std::uint64_t num_tracks_begun_ = 0;
};

}  // namespace rigidformer_ros
