// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/stillness.hpp"

namespace rigidformer {
namespace {

// Of the noise of a point, which the poses of an object at rest stay within. On the real table scenes
// (docs/reliability.md) they left one such noise in every third cloud, and two in none of 60, with which it was chosen.
constexpr double kStillNoise = 2.0;

}  // namespace

Stillness seen_still(const PoseHistory& poses, const Points& points_object, const Stillness& before, double noise_m) {
  const Eigen::RowVector3f centre = points_object.colwise().mean();
  const double radius_m = (points_object.rowwise() - centre).rowwise().norm().maxCoeff();
  Stillness still = poses.stillness(centre.transpose().cast<double>(), radius_m, kStillNoise * noise_m);
  if (before.num_poses > 0 && still.num_poses == static_cast<int>(poses.size())) {
    still = {still.seconds + before.seconds, still.num_poses + before.num_poses - 1};
  }
  return still;
}

}  // namespace rigidformer
