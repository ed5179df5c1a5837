// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace rigidformer {

/// How the points of one object in two clouds correspond.
enum class Correspondence {
  kOrdered,       ///< The same points in the same order, as simulators give them
  kRegistration,  ///< Any points, as cameras give them; the pose is found by registration
  kPose           ///< Any points; a tracker gives the pose
};

/// When a track goes on and when another begins. A member's name is its YAML key under `history:`. The defaults were
/// chosen by eye (docs/tracking.md, "All thresholds").
struct HistoryOptions {
  double min_dt = 0.005;        ///< [s] clouds closer than this replace each other
  double max_dt = 0.3;          ///< [s] a longer gap begins a new track
  double object_timeout = 1.0;  ///< [s] objects unseen for longer are forgotten
  double jump_threshold = 0.5;  ///< [s] a stamp that lies farther back means that time restarted; less is a late cloud
  double max_speed = 20.0;      ///< [m/s] a faster object is another one under the same id: a new track begins
  double max_angular_speed = 80.0;  ///< [rad/s] an object that turns faster is another one too
};

/// How poses are found and judged (docs/tracking.md). A member's name is its YAML key under `correspondence:`; [size]
/// is the object's diameter. The defaults were chosen by eye.
struct CorrespondenceOptions {
  Correspondence method = Correspondence::kOrdered;
  double max_rmse = 0.02;                    ///< [m] a pose whose residuals have a larger RMSE is LOW_QUALITY
  double noise = 0.003;                      ///< [m] standard deviation of a measured point
  double min_inlier_ratio = 0.6;             ///< Share of a cloud's points that must lie on the reference cloud
  double voxel_size = 0.03;                  ///< [size] spacing of the reference cloud's points
  int max_reference_points = 4000;           ///< The spacing grows when the reference cloud would have more points
  double max_correspondence_distance = 0.1;  ///< [size] points farther apart do not attract each other
  int max_iterations = 30;                   ///< Steps of one registration at most
  int max_registered_points = 400;           ///< Points to which a cloud is thinned for registration
  double max_rotation = 0.6;                 ///< [rad] a rotation farther than this from the predicted one is refused
  int max_failures = 5;                      ///< A new track begins after more clouds in a row that do not fit
};

/// Everything that sets up a TrackStore.
struct TrackingOptions {
  int min_points = 4;          ///< A cloud with fewer finite points is refused
  double sync_window_s = 0.1;  ///< [s] an object seen longer than this before the newest one is left out of the scene
  HistoryOptions history;
  CorrespondenceOptions correspondence;
};

}  // namespace rigidformer
