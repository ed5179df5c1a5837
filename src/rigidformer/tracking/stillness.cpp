// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/stillness.hpp"

namespace rigidformer {
namespace {

// Share of the noise of a point that the poses of an object at rest stay within: a pose comes from many points, but the
// first clouds of a track show its ends blurred.
constexpr double kStillNoise = 1.0;
constexpr int kFewestPoses = 3;  // derived: two may show the same place on the way up and on the way down

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

double stood_s(const Stillness& still) { return still.num_poses < kFewestPoses ? 0.0 : still.seconds; }

}  // namespace rigidformer
