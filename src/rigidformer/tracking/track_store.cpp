// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/track_store.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer/geometry/rigid_registration.hpp"
#include "rigidformer/scene/objection.hpp"
#include "rigidformer/tracking/cloud_registration.hpp"
#include "rigidformer/tracking/scene_instant.hpp"
#include "rigidformer/tracking/track.hpp"

namespace rigidformer {

namespace {

RegistrationQuality measure(const RigidTransform& T, const Points& reference, const Points& cloud, double inlier_m) {
  const Eigen::VectorXd residuals = registration_residuals(T, reference, cloud);
  const auto inliers = (residuals.array() <= inlier_m).count();
  return {std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size())),
          static_cast<double>(inliers) / static_cast<double>(residuals.size())};
}

Stamp arrival_of(const ObjectObservation& observation) {
  return observation.arrival == Stamp() ? observation.stamp : observation.arrival;
}

std::vector<int> common_rows(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

}  // namespace

TrackStore::TrackStore(const TrackingOptions& options) : options_(options) {}
TrackStore::~TrackStore() = default;
TrackStore::TrackStore(TrackStore&&) noexcept = default;
TrackStore& TrackStore::operator=(TrackStore&&) noexcept = default;

void TrackStore::clear() { tracks_.clear(); }

AddResult TrackStore::add(const ObjectObservation& observation) {
  if (options_.correspondence.method == Correspondence::kPose && !observation.T_world_object) {
    return AddResult::kNoPose;
  }
  const std::vector<int> seen_rows = finite_rows(observation.points_world);
  if (seen_rows.size() < static_cast<std::size_t>(options_.min_points)) {
    return AddResult::kTooFewPoints;
  }
  const auto found = tracks_.find(observation.id);
  if (found == tracks_.end()) return begin_track(observation, seen_rows);
  Track& track = *found->second;
  const double dt = seconds_between(track.poses.newest_stamp(), observation.stamp);
  if (dt < -options_.history.jump_threshold) {
    clear();
    begin_track(observation, seen_rows);
    return AddResult::kTimeRestarted;
  }
  if (dt < 0.0) return AddResult::kLate;
  if (dt > options_.history.max_dt) {
    begin_track(observation, seen_rows);
    return AddResult::kNewTrackAfterGap;
  }
  return extend_track(track, observation, seen_rows);
}

AddResult TrackStore::begin_track(const ObjectObservation& observation, const std::vector<int>& seen_rows) {
  Track track;
  track.number = ++num_tracks_begun_;
  track.rows = seen_rows;
  track.mode = observation.mode;
  track.properties = observation.properties;
  track.frame_is_given = observation.T_world_object.has_value();
  const Points seen = select_rows(observation.points_world, track.rows);
  const RigidTransform T_world_object = observation.T_world_object.value_or(
      RigidTransform{Eigen::Quaterniond::Identity(), seen.cast<double>().colwise().mean().transpose()});
  if (is_ordered()) {
    track.points_reference = T_world_object.inverse().apply(observation.points_world);
  } else {
    track.tracker.emplace(seen, T_world_object, options_.correspondence);
  }
  track.poses.add(observation.stamp, T_world_object, options_.history.min_dt);
  track.arrival = arrival_of(observation);
  track.before = stillness_before(observation, seen_rows);
  tracks_[observation.id] = std::make_unique<Track>(std::move(track));
  return taken_in(*tracks_[observation.id], AddResult::kNewTrack);
}

AddResult TrackStore::extend_track(Track& track, const ObjectObservation& observation,
                                   const std::vector<int>& seen_rows) {
  const auto found = is_ordered() ? match_rows(track, observation, seen_rows) : follow(track, observation, seen_rows);
  if (!found || is_too_fast(track, observation.stamp, found->T_world_object)) {
    return begin_track(observation, seen_rows);
  }
  track.poses.add(observation.stamp, found->T_world_object, options_.history.min_dt);
  track.arrival = arrival_of(observation);
  track.quality = found->quality;
  track.low_quality = !found->objection.empty() || found->may_have_slid;
  track.mode = observation.mode;
  track.properties = observation.properties;
  return taken_in(track, track.low_quality ? AddResult::kLowQuality : AddResult::kExtended);
}

// Whether an object can be predicted changes with its growing reference cloud and with its properties.
AddResult TrackStore::taken_in(Track& track, AddResult result) {
  ObjectState state;
  state.points_reference = track.known_points();
  state.T_world_previous = state.T_world_current = track.poses.newest_pose();
  state.properties = track.properties;
  track.objection = objection(state, options_.length_scale);
  forget_unseen();
  return result;
}

// Compares a cloud with the reference row by row; empty when the cloud has other rows than the reference.
std::optional<CloudRegistration> TrackStore::match_rows(const Track& track, const ObjectObservation& observation,
                                                        const std::vector<int>& seen_rows) const {
  if (observation.points_world.rows() != track.points_reference.rows()) {
    return std::nullopt;
  }
  const std::vector<int> rows = common_rows(track.rows, seen_rows);
  if (rows.size() < static_cast<std::size_t>(options_.min_points)) {
    return std::nullopt;
  }
  const Points reference = select_rows(track.points_reference, rows);
  const Points cloud = select_rows(observation.points_world, rows);
  CloudRegistration found;
  found.T_world_object = observation.T_world_object.value_or(fit_rigid_transform(reference, cloud));
  found.quality = measure(found.T_world_object, reference, cloud, options_.correspondence.max_rmse);
  found.objection = found.quality.rmse_m > options_.correspondence.max_rmse ? "no rigid motion fits" : "";
  return found;
}

// Follows a cloud without order; empty when it cannot be the tracked object any more or has another object frame.
std::optional<CloudRegistration> TrackStore::follow(Track& track, const ObjectObservation& observation,
                                                    const std::vector<int>& seen_rows) const {
  const Points points = select_rows(observation.points_world, seen_rows);
  if (observation.T_world_object) {
    return track.frame_is_given ? std::optional(track.tracker->learn(points, *observation.T_world_object))
                                : std::nullopt;
  }
  const RigidTransform& T_world_previous = track.poses.newest_pose();
  if (track.is_static()) {
    return track.tracker->stay(points, T_world_previous);
  }
  const RigidTransform T_world_predicted = track.poses.predict(observation.stamp);
  // An impact can stop or turn a known velocity, hence the factor 2 (chosen by eye). The
  // second cloud may have any speed.
  const double max_jump_m = track.poses.size() > 1
                                ? 2.0 * (T_world_predicted.translation - T_world_previous.translation).norm()
                                : options_.history.max_speed * seconds_since(track, observation.stamp);
  return track.tracker->follow(points, T_world_previous, T_world_predicted, max_jump_m);
}

bool TrackStore::is_too_fast(const Track& track, Stamp stamp, const RigidTransform& T_world_object) const {
  const double dt = seconds_since(track, stamp);
  const RigidTransform& before = track.poses.newest_pose();
  return (T_world_object.translation - before.translation).norm() > options_.history.max_speed * dt ||
         rotation_angle(T_world_object.rotation, before.rotation) > options_.history.max_angular_speed * dt;
}

double TrackStore::seconds_since(const Track& track, Stamp stamp) const {
  return std::max(seconds_between(track.poses.newest_stamp(), stamp), options_.history.min_dt);
}

// Static objects may be seen only once (a latched table): they stay until clear(), unless they are of no use anyway.
// Arrivals are compared, not stamps: a sensor whose clock is ahead must not make the objects of the others look old.
void TrackStore::forget_unseen() {
  Stamp newest;
  for (const auto& [id, track] : tracks_) {
    newest = std::max(newest, track->arrival);
  }
  for (auto it = tracks_.begin(); it != tracks_.end();) {
    const bool stays = it->second->is_static() && !it->second->objection;
    const bool expired = !stays && seconds_between(it->second->arrival, newest) > options_.history.object_timeout;
    it = expired ? tracks_.erase(it) : std::next(it);
  }
}

// The newest clouds of the objects that move, or those of the static ones where nothing moves, or what else there is.
std::vector<Sighting> TrackStore::sightings() const {
  std::vector<Sighting> moving, standing, unusable;
  for (const auto& [id, track] : tracks_) {
    std::vector<Sighting>& kind = track->objection ? unusable : track->is_static() ? standing : moving;
    kind.push_back({id, track->poses.newest_stamp(), track->arrival});
  }
  return !moving.empty() ? moving : !standing.empty() ? standing : unusable;
}

ObservedScene TrackStore::snapshot(double time_step_s) const {
  ObservedScene scene;
  scene.time_step_s = time_step_s;
  if (tracks_.empty()) {
    return scene;
  }
  const std::vector<Sighting> seen = sightings();
  const SceneInstant instant = choose_instant(seen, options_.sync_window_s);
  scene.stamp = instant.stamp;
  scene.clock_remark = instant.clock_remark;
  std::size_t next = 0;
  for (const auto& [id, track] : tracks_) {
    if (track->objection) {
      scene.skipped.push_back({id, *track->objection, SkipCause::kUnusable});
    } else if (track->is_static()) {
      scene.objects.push_back(observe(id, *track, scene.stamp, time_step_s));
    } else {
      add_moving(scene, id, *track, instant.presence[next++]);
    }
  }
  return scene;
}

void TrackStore::add_moving(ObservedScene& scene, const std::string& id, const Track& track, Presence presence) const {
  if (presence == Presence::kUnseen) {
    const double unseen_s = seconds_between(track.arrival, newest_arrival());
    scene.skipped.push_back({id, "not seen for " + std::to_string(unseen_s) + " s (input/sync_window is " +
                                     std::to_string(options_.sync_window_s) + " s)"});
  } else if (presence == Presence::kOwnClock) {
    scene.objects.push_back(observe(id, track, track.poses.newest_stamp(), scene.time_step_s));
    scene.objects.back().low_quality = true;
  } else if (!track.poses.pose_at(scene.stamp)) {
    scene.skipped.push_back({id, "seen for the first time after the other objects"});
  } else {
    scene.objects.push_back(observe(id, track, scene.stamp, scene.time_step_s));
  }
}

Stamp TrackStore::newest_arrival() const {
  Stamp newest;
  for (const auto& [id, track] : tracks_) {
    if (!track->is_static() && !track->objection) {
      newest = std::max(newest, track->arrival);
    }
  }
  return newest;
}

std::optional<Stamp> TrackStore::newest_stamp_of(const std::string& id) const {
  const auto found = tracks_.find(id);
  return found == tracks_.end() ? std::nullopt : std::optional(found->second->poses.newest_stamp());
}

std::optional<std::string> TrackStore::objection_to(const std::string& id) const {
  const auto found = tracks_.find(id);
  return found == tracks_.end() ? std::nullopt : found->second->objection;
}

TrackRecords TrackStore::records() const {
  TrackRecords records;
  for (const auto& [id, track] : tracks_) {
    records[id] = {track->number, track->poses, track->low_quality};
  }
  return records;
}

ObservedObject TrackStore::observe(const std::string& id, const Track& track, Stamp stamp, double time_step_s) const {
  ObservedObject object;
  object.state.id = id;
  object.state.mode = track.mode;
  object.state.points_reference = track.known_points();
  object.state.properties = track.properties;
  object.quality = track.quality;
  object.track = track.number;
  object.low_quality = track.low_quality;
  if (track.is_static()) {
    object.state.T_world_current = track.poses.newest_pose();
    object.state.T_world_previous = track.poses.newest_pose();
    return object;
  }
  object.state.T_world_current = *track.poses.pose_at(stamp);
  const auto previous = track.poses.pose_before(stamp, time_step_s);
  object.assumed_static = !previous;
  object.state.T_world_previous = previous.value_or(object.state.T_world_current);
  object.state.stood_s = stillness_of(track).seconds;
  return object;
}

}  // namespace rigidformer
