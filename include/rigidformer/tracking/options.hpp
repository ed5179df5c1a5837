// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace rigidformer {

/// How the points of one object in two clouds belong together.
enum class Correspondence {
  kOrdered,       ///< The same points in the same order, as simulators give them
  kRegistration,  ///< Any points, as cameras give them: the pose is found by registration
  kPose           ///< Any points, and a tracker gives the pose
};

/// When a track goes on and when another begins. A member's name is its YAML key under `history:`.
struct HistoryOptions {
  double min_dt = 0.005;            ///< [s] clouds closer than this replace each other
  double max_dt = 0.3;              ///< [s] a gap longer than this restarts the track
  double object_timeout = 1.0;      ///< [s] objects unseen for longer are forgotten
  double jump_threshold = 0.5;      ///< [s] stamps this far back mean that time restarted; less is a late cloud
  double max_speed = 20.0;          ///< [m/s] faster than this is another object under the same id: new track
  double max_angular_speed = 80.0;  ///< [rad/s] likewise
};

/// How poses are found and judged. A member's name is its YAML key under `correspondence:`; "size" is the object's
/// diameter.
struct CorrespondenceOptions {
  Correspondence method = Correspondence::kOrdered;
  double max_rmse = 0.02;                    ///< [m] above this the observed pose counts as LOW_QUALITY
  double noise = 0.003;                      ///< [m] standard deviation of a measured point
  double min_inlier_ratio = 0.6;             ///< Share of a cloud that must lie on the reference surface
  double voxel_size = 0.03;                  ///< [size] spacing of the reference cloud
  int max_reference_points = 4000;           ///< The spacing grows when the reference would have more
  double max_correspondence_distance = 0.1;  ///< [size] farther points do not attract each other
  int max_iterations = 30;                   ///< Of one registration
  int max_registered_points = 400;           ///< Clouds are thinned to this many for registration
  double max_rotation = 0.6;                 ///< [rad] a registered rotation farther from the predicted one is refused
  int max_failures = 5;                      ///< After this many clouds in a row that do not fit the track begins anew
};

/// Everything that a TrackStore wants to know.
struct TrackingOptions {
  int min_points = 4;                        ///< Finite points below which a cloud is refused
  double sync_window_s = 0.1;                ///< An object seen longer ago than this before the newest sits out
  std::optional<double> length_scale = 1.0;  ///< At which objections count (scene/objection.hpp)
  HistoryOptions history;
  CorrespondenceOptions correspondence;
};

}  // namespace rigidformer
