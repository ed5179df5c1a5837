// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/live_scene.hpp"

#include <ros/console.h>

#include <algorithm>
#include <sstream>

namespace rigidformer_ros {

using rigidformer::AddResult;

LiveScene::LiveScene(const NodeParameters& parameters, RejectionLog& rejections)
    : rejections_(rejections),
      gate_(parameters.max_stamp_skew, parameters.history.jump_threshold),
      tracks_(tracking_options(parameters)),
      max_dt_s_(parameters.history.max_dt) {}

bool LiveScene::accepts(const std::string& id, const ros::Time& stamp, const ros::Time& now) {
  watch_clock(now);
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto objection = gate_.objection(stamp, now);
  if (objection) {
    rejections_.add("bad stamp", "'" + id + "': " + *objection);
  }
  return !objection;
}

void LiveScene::add(const ObjectObservation& observation) {
  const std::lock_guard<std::mutex> lock(mutex_);
  newest_arrival_ = std::max(newest_arrival_, observation.arrival);
  const auto before = tracks_.newest_stamp_of(observation.id);
  const AddResult result = tracks_.add(observation);
  if (result == AddResult::kTimeRestarted) {
    ++epoch_;
    ROS_INFO_STREAM("Stamps of '" << observation.id << "' jumped back: all tracks were cleared.");
  }
  if (!count_dropped(observation.id, result)) {
    count_taken(observation, result, before);
  }
}

bool LiveScene::count_dropped(const std::string& id, AddResult result) {
  switch (result) {
    case AddResult::kLate:
      rejections_.add("late cloud", "'" + id + "': older than the newest one of its object");
      break;
    case AddResult::kTooFewPoints:
      rejections_.add("too few points", "'" + id + "': fewer finite points than input/min_points");
      break;
    case AddResult::kNoPose:
      rejections_.add("no pose", "'" + id + "': correspondence/method is pose, but no pose came with it");
      break;
    default:
      return false;
  }
  return true;
}

// One reason per cloud, the one that costs its object most.
void LiveScene::count_taken(const ObjectObservation& observation, AddResult result,
                            std::optional<rigidformer::Stamp> before) {
  if (const auto objection = tracks_.objection_to(observation.id)) {
    rejections_.add(kUnusableObject, "'" + observation.id + "': " + *objection);
  } else if (result == AddResult::kLowQuality) {
    rejections_.note("cloud that fits no pose well", "'" + observation.id + "': forecast with status LOW_QUALITY");
  } else if (result == AddResult::kNewTrackAfterGap) {
    rejections_.note("gap between clouds", describe_gap(observation, *before));
  }
}

std::string LiveScene::describe_gap(const ObjectObservation& observation, rigidformer::Stamp before) const {
  std::ostringstream text;
  text << "clouds of '" << observation.id << "' came " << rigidformer::seconds_between(before, observation.stamp)
       << " s apart, history/max_dt is " << max_dt_s_ << " s: its track began anew and its velocity is not known";
  return text.str();
}

bool LiveScene::is_fed(rigidformer::Stamp now, double timeout_s) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return rigidformer::seconds_between(newest_arrival_, now) <= timeout_s;
}

void LiveScene::watch_clock(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (gate_.clock_restarted(now)) {
    tracks_.clear();
    newest_arrival_ = {};
    ++epoch_;
    ROS_INFO_STREAM("The clock jumped back to " << now.toSec() << " s: all tracks were cleared.");
  }
}

void LiveScene::reset() {
  const std::lock_guard<std::mutex> lock(mutex_);
  tracks_.clear();
  ++epoch_;
}

ObservedScene LiveScene::snapshot(double time_step_s) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return tracks_.snapshot(time_step_s);
}

TrackRecords LiveScene::records() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return tracks_.records();
}

std::uint64_t LiveScene::epoch() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return epoch_;
}

}  // namespace rigidformer_ros
