// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "rigidformer/io/members.hpp"

namespace rigidformer {

/// How the points of one object in two clouds correspond.
enum class Correspondence {
  kOrdered,       ///< The same points in the same order, as simulators give them
  kRegistration,  ///< Any points, as cameras give them; the pose is found by registration
  kPose           ///< Any points; a tracker gives the pose
};

inline EnumNames<Correspondence> names_of(Correspondence) {
  return {{"ordered", Correspondence::kOrdered},
          {"registration", Correspondence::kRegistration},
          {"pose", Correspondence::kPose}};
}

/// When a track goes on and when another begins. A member's name is its YAML key under `history:`.
struct HistoryOptions {
  double min_dt = 0.005;
  double max_dt = 0.3;
  double object_timeout = 1.0;
  double jump_threshold = 0.5;
  double max_speed = 20.0;
  double max_angular_speed = 80.0;
};

template <typename Visit>
void for_each_member(HistoryOptions& o, const Visit& visit) {
  visit("min_dt", o.min_dt, between(1e-4, 1.0), "[s] clouds closer than this replace each other");
  visit("max_dt", o.max_dt, between(1e-3, 10.0), "[s] a longer gap begins a new track; more than `min_dt`");
  visit("object_timeout", o.object_timeout, between(1e-3, 3600.0), "[s] objects unseen for longer are forgotten");
  visit("jump_threshold", o.jump_threshold, between(1e-3, 3600.0),
        "[s] time running back by more clears all tracks, by less drops a cloud");
  visit("max_speed", o.max_speed, between(0.01, 1e4), "[m/s] a faster move is another object: new track");
  visit("max_angular_speed", o.max_angular_speed, between(0.01, 1e4), "[rad/s] likewise");
}

/// How poses are found and judged. A member's name is its YAML key under `correspondence:`; "size" is the object's
/// diameter.
struct CorrespondenceOptions {
  Correspondence method = Correspondence::kOrdered;
  double max_rmse = 0.02;
  double noise = 0.003;
  double min_inlier_ratio = 0.6;
  double voxel_size = 0.03;
  int max_reference_points = 4000;
  double max_correspondence_distance = 0.1;
  int max_iterations = 30;
  int max_registered_points = 400;
  double max_rotation = 0.6;
  int max_failures = 5;
};

template <typename Visit>
void for_each_member(CorrespondenceOptions& o, const Visit& visit) {
  visit("method", o.method, anything(), "how points of two clouds belong together");
  visit("max_rmse", o.max_rmse, between(1e-6, 10.0), "[m] a worse fit is LOW_QUALITY");
  visit("noise", o.noise, between(1e-6, 1.0), "[m] standard deviation of a measured point");
  visit("min_inlier_ratio", o.min_inlier_ratio, share(), "share of a cloud that must lie on the reference");
  visit("voxel_size", o.voxel_size, between(0.005, 0.5), "[size] spacing of the reference cloud");
  visit("max_reference_points", o.max_reference_points, between(50, 1e5), "the spacing grows when there would be more");
  visit("max_correspondence_distance", o.max_correspondence_distance, between(0.01, 1.0),
        "[size] farther points do not attract each other");
  visit("max_iterations", o.max_iterations, between(1, 1000), "steps of a registration");
  visit("max_registered_points", o.max_registered_points, between(50, 1e5),
        "clouds are thinned to this many for registration");
  visit("max_rotation", o.max_rotation, between(0.01, 3.15), "[rad] a turn farther from the prediction is refused");
  visit("max_failures", o.max_failures, between(0, 1000), "more clouds in a row that do not fit begin a new track");
}

/// Everything that a TrackStore wants to know.
struct TrackingOptions {
  int min_points = 4;          ///< A cloud with fewer finite points is refused
  double sync_window_s = 0.1;  ///< [s] an object seen longer than this before the newest one is left out of the scene
  std::optional<double> length_scale = 1.0;  ///< At which objections count (scene/objection.hpp)
  HistoryOptions history;
  CorrespondenceOptions correspondence;
};

}  // namespace rigidformer
