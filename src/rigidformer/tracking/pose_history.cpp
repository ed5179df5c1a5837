// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/pose_history.hpp"

#include <cmath>

namespace rigidformer {

namespace {

constexpr std::size_t kMaxEntries = 128;  // poses of one object: more than half a second at 200 Hz; chosen by eye
constexpr double kMaxSpacingRatio = 3.0;  // ratio of frames' distances; beyond it a parabola amplifies noise; by eye
constexpr double kTwistBaseline = 0.03;   // [s] poses closer together give noise, not a velocity; chosen by eye
constexpr double kSameInstant = 1e-9;     // [s] derived: the resolution of a stamp

}  // namespace

void PoseHistory::add(Stamp stamp, const RigidTransform& T_world_object, double min_dt_s) {
  if (!entries_.empty() &&
      (stamp == entries_.back().stamp || seconds_between(entries_.back().first_stamp, stamp) < min_dt_s)) {
    entries_.back().stamp = stamp;
    entries_.back().T_world_object = T_world_object;
    return;
  }
  entries_.push_back({stamp, stamp, T_world_object});
  if (entries_.size() > kMaxEntries) {
    entries_.pop_front();
  }
}

std::optional<RigidTransform> PoseHistory::pose_before(Stamp stamp, double seconds) const {
  const auto into = [&](std::size_t i) { return seconds_between(entries_[i].stamp, stamp) - seconds; };
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (std::abs(into(i)) < kSameInstant) {
      return entries_[i].T_world_object;
    }
  }
  if (entries_.size() < 2) {
    return std::nullopt;
  }
  // The instant lies in the segment [i, i + 1], or the pose is extrapolated from the first or last segment.
  std::size_t segment = 0;
  while (segment + 2 < entries_.size() && into(segment + 1) > 0.0) {
    ++segment;
  }
  const double fraction = into(segment) / spacing_s(segment, segment + 1);
  if (fraction < -1.0 || fraction > 2.0) {
    return std::nullopt;
  }
  RigidTransform pose = interpolate(entries_[segment].T_world_object, entries_[segment + 1].T_world_object, fraction);
  pose.translation = position_at(segment, into(segment));
  return pose;
}

RigidTransform PoseHistory::predict(Stamp stamp) const {
  if (entries_.size() < 2) {
    return newest_pose();
  }
  const std::size_t last = entries_.size() - 1;
  std::size_t first = last - 1;
  while (first > 0 && spacing_s(first, last) < kTwistBaseline) {
    --first;
  }
  const double fraction = seconds_between(entries_[first].stamp, stamp) / spacing_s(first, last);
  return interpolate(entries_[first].T_world_object, entries_[last].T_world_object, fraction);
}

Stillness PoseHistory::stillness(const Eigen::Vector3d& centre, double radius_m, double tolerance_m) const {
  const RigidTransform& newest = newest_pose();
  Stillness still;
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    const RigidTransform& pose = entry->T_world_object;
    const double way_m =
        (pose * centre - newest * centre).norm() + radius_m * rotation_angle(pose.rotation, newest.rotation);
    if (way_m > tolerance_m) break;
    still = {seconds_between(entry->stamp, newest_stamp()), still.num_poses + 1};
  }
  return still;
}

double PoseHistory::spacing_s(std::size_t reference, std::size_t index) const {
  return seconds_between(entries_[reference].stamp, entries_[index].stamp);
}

Eigen::Vector3d PoseHistory::position_at(std::size_t segment, double t) const {
  const auto position = [&](std::size_t i) { return entries_[i].T_world_object.translation; };
  const double width = spacing_s(segment, segment + 1);
  const bool has_before = segment > 0;
  if (has_before || segment + 2 < entries_.size()) {
    const std::size_t third = has_before ? segment - 1 : segment + 2;
    const double c = spacing_s(segment, third);
    const double gap = has_before ? -c : c - width;
    if (gap * kMaxSpacingRatio > width && gap < kMaxSpacingRatio * width) {
      return position(segment) * ((t - width) * (t - c) / (width * c)) +
             position(segment + 1) * (t * (t - c) / (width * (width - c))) +
             position(third) * (t * (t - width) / (c * (c - width)));
    }
  }
  return position(segment) + (t / width) * (position(segment + 1) - position(segment));
}

}  // namespace rigidformer
