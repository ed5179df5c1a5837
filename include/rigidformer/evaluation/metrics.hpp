// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// Error of one scene at one moment, or the mean of such errors over scenes.
struct PoseError {
  double position_rmse_m = 0.0;
  double orientation_rmse_deg = 0.0;
  double position_rmse_sizes = 0.0;  ///< Position in largest extents of the object; 0 where none was given
};

/// Pose between the steps of a forecast: `step` counts time steps from poses[0] and need not be whole. The position is
/// interpolated linearly, the rotation by slerp. Throws std::out_of_range when `step` lies outside the forecast.
RigidTransform pose_at_step(const std::vector<RigidTransform>& poses, double step);

/// Root mean square over objects of the distance of the origins and of the geodesic angle between the orientations.
/// `extents_m` are the objects' sizes; without them no error is given in sizes. Throws std::invalid_argument for no
/// objects or different counts.
PoseError scene_error(const std::vector<RigidTransform>& predicted, const std::vector<RigidTransform>& truth,
                      const std::vector<double>& extents_m = {});

/// Angle [rad] between the directions in the two body frames that point up: 0 for two orientations that differ by a
/// turn about the vertical only, as those of a thing that rests on the same face do.
double tilt_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

/// Mean over scenes of their errors. Throws std::invalid_argument for no scenes.
PoseError mean_error(const std::vector<PoseError>& scenes);

}  // namespace rigidformer
