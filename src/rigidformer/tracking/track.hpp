// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer/tracking/cloud_tracker.hpp"
#include "rigidformer/tracking/stillness.hpp"
#include "rigidformer/tracking/track_store.hpp"

namespace rigidformer {

/// One object as it was seen since the track began.
struct TrackStore::Track {
  std::uint64_t number = 0;
  Points points_reference;  ///< With `ordered`: all rows of the first cloud, about the centroid of the finite ones
  std::vector<int> rows;    ///< With `ordered`: the finite rows of the reference
  std::optional<CloudTracker> tracker;  ///< With the other ways of correspondence: follows the clouds
  bool frame_is_given = false;          ///< The object frame is that of the given poses
  PoseHistory poses;
  Stillness before;  ///< Up to the first of the poses: what an earlier track saw of the object in this place
  Stamp arrival;     ///< When the newest cloud came
  RegistrationQuality quality;
  bool low_quality = false;
  MotionMode mode = MotionMode::kDynamic;
  BodyProperties properties;

  std::optional<std::string> objection;  ///< Why it cannot be predicted, with what is known of it now

  bool is_static() const { return mode == MotionMode::kStatic; }
  Points known_points() const { return tracker ? tracker->points_object() : select_rows(points_reference, rows); }
};

}  // namespace rigidformer
