// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/live_scene.hpp"

#include <ros/console.h>

namespace rigidformer_ros {

using rigidformer::AddResult;

LiveScene::LiveScene(const NodeParameters& parameters, RejectionLog& rejections)
    : rejections_(rejections),
      gate_(parameters.max_stamp_skew, parameters.history.jump_threshold),
      tracks_(tracking_options(parameters)) {}

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
  const AddResult result = tracks_.add(observation);
  count(observation.id, result);
  if (result == AddResult::kTimeRestarted) {
    ++epoch_;
    ROS_INFO_STREAM("Stamps of '" << observation.id << "' jumped back: all tracks were cleared.");
  }
}

// Each cloud that leads to no forecast of its object, or to a poor one, for one reason.
void LiveScene::count(const std::string& id, AddResult result) {
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
      if (const auto objection = tracks_.objection_to(id)) {
        rejections_.add(kUnusableObject, "'" + id + "': " + *objection);
      } else if (result == AddResult::kLowQuality) {
        rejections_.add("cloud that fits no pose well", "'" + id + "': forecast with status LOW_QUALITY");
      }
      break;
  }
}

void LiveScene::watch_clock(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (gate_.clock_restarted(now)) {
    tracks_.clear();
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
