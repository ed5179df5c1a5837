// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/evaluation/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace rigidformer {

RigidTransform pose_at_step(const std::vector<RigidTransform>& poses, double step) {
  const double last = static_cast<double>(poses.size()) - 1.0;
  if (!(step >= 0.0 && step <= last)) {
    throw std::out_of_range("pose_at_step: step " + std::to_string(step) + " lies outside 0 ... " +
                            std::to_string(last));
  }
  const auto before = static_cast<std::size_t>(step);
  const std::size_t after = std::min(before + 1, poses.size() - 1);
  const double fraction = step - static_cast<double>(before);
  return fraction == 0.0 ? poses[before] : interpolate(poses[before], poses[after], fraction);
}

PoseError scene_error(const std::vector<RigidTransform>& predicted, const std::vector<RigidTransform>& truth,
                      const std::vector<double>& extents_m) {
  if (predicted.empty() || predicted.size() != truth.size() ||
      (!extents_m.empty() && extents_m.size() != truth.size())) {
    throw std::invalid_argument("scene_error: " + std::to_string(predicted.size()) + " predicted poses and " +
                                std::to_string(extents_m.size()) + " sizes for " + std::to_string(truth.size()) +
                                " true poses");
  }
  double squared_distance = 0.0;
  double squared_sizes = 0.0;
  double squared_angle = 0.0;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    const double squared = (predicted[i].translation - truth[i].translation).squaredNorm();
    squared_distance += squared;
    if (!extents_m.empty()) squared_sizes += squared / (extents_m[i] * extents_m[i]);
    const double angle = rotation_angle(predicted[i].rotation, truth[i].rotation);
    squared_angle += angle * angle;
  }
  const auto count = static_cast<double>(predicted.size());
  return {std::sqrt(squared_distance / count), std::sqrt(squared_angle / count) * 180.0 / M_PI,
          std::sqrt(squared_sizes / count)};
}

double tilt_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Vector3d up_a = a.conjugate() * Eigen::Vector3d::UnitZ(),
                        up_b = b.conjugate() * Eigen::Vector3d::UnitZ();
  return std::atan2(up_a.cross(up_b).norm(), up_a.dot(up_b));
}

PoseError mean_error(const std::vector<PoseError>& scenes) {
  if (scenes.empty()) {
    throw std::invalid_argument("mean_error: no scenes");
  }
  PoseError mean;
  for (const PoseError& scene : scenes) {
    mean.position_rmse_m += scene.position_rmse_m / static_cast<double>(scenes.size());
    mean.orientation_rmse_deg += scene.orientation_rmse_deg / static_cast<double>(scenes.size());
    mean.position_rmse_sizes += scene.position_rmse_sizes / static_cast<double>(scenes.size());
  }
  return mean;
}

}  // namespace rigidformer
