// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/farthest_point_sampling.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace rigidformer {
namespace {

/// Coordinates stored by column: sums over many points then use the processor's vector units.
class Distances {
 public:
  explicit Distances(const Points& points) : x_(points.col(0)), y_(points.col(1)), z_(points.col(2)) {}

  /// Squared distances of all points from `p`.
  auto from(const Eigen::RowVector3f& p) const {
    return (x_ - p.x()).square() + ((y_ - p.y()).square() + (z_ - p.z()).square());
  }

 private:
  Eigen::ArrayXf x_, y_, z_;
};

/// Row of the largest of values of which none is NaN. It is faster than maxCoeff(&index), which
/// looks at one value after the other.
Eigen::Index first_largest(const Eigen::ArrayXf& values) {
  const float* last = values.data() + values.size() - 1;
  return std::find(values.data(), last, values.maxCoeff()) - values.data();
}

}  // namespace

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
  const Distances squared_distances(points);
  Eigen::ArrayXf distances = squared_distances.from(centroid);
  Eigen::Index farthest = first_largest(distances);
  distances.setConstant(std::numeric_limits<float>::infinity());
  while (true) {
    order.push_back(static_cast<int>(farthest));
    if (static_cast<Eigen::Index>(order.size()) == num_chosen) {
      return order;
    }
    distances = distances.min(squared_distances.from(points.row(farthest)));
    distances[farthest] = -1.0F;  // a chosen point is not chosen again, even among coinciding points
    farthest = first_largest(distances);
  }
}

}  // namespace rigidformer
