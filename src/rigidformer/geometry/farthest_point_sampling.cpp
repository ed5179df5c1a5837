// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/farthest_point_sampling.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace rigidformer {

std::vector<int> farthest_point_order(const Points& points, int count) {
  if (count < 0) {
    throw std::invalid_argument("farthest point sampling: count is " + std::to_string(count) +
                                ", must not be negative");
  }
  const auto num_chosen = std::min<Eigen::Index>(count, points.rows());
  std::vector<int> order;
  order.reserve(num_chosen);
  if (num_chosen == 0) {
    return order;
  }
  const Eigen::RowVector3f centroid = points.cast<double>().colwise().mean().cast<float>();
  Eigen::VectorXf distances = (points.rowwise() - centroid).rowwise().squaredNorm();
  Eigen::Index farthest = 0;
  distances.maxCoeff(&farthest);
  distances.setConstant(std::numeric_limits<float>::infinity());
  while (true) {
    order.push_back(static_cast<int>(farthest));
    if (static_cast<Eigen::Index>(order.size()) == num_chosen) {
      return order;
    }
    distances = distances.cwiseMin((points.rowwise() - points.row(farthest).eval()).rowwise().squaredNorm());
    distances[farthest] = -1.0F;  // never chosen twice, even among coinciding points
    distances.maxCoeff(&farthest);
  }
}

}  // namespace rigidformer
