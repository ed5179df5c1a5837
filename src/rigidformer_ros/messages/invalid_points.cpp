// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/invalid_points.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace rigidformer_ros {

namespace {

using rigidformer::Points;
using Value = std::array<float, 3>;

// Two pixels of a camera never measure one and the same point: their rays differ. A few equal ones may come from a
// simulated mesh, whose faces share vertices.
constexpr std::size_t kFewestRepetitions = 10;  // points, chosen by eye
constexpr double kSmallestShare = 0.01;         // of the finite points, chosen by eye

Value value_of(const Points& points, Eigen::Index row) { return {points(row, 0), points(row, 1), points(row, 2)}; }

// The values that too many of the finite rows share.
std::vector<Value> repeated_values(const Points& points) {
  std::vector<Value> values;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (points.row(i).allFinite()) {
      values.push_back(value_of(points, i));
    }
  }
  std::sort(values.begin(), values.end());
  const double fewest = std::max<double>(kFewestRepetitions, kSmallestShare * static_cast<double>(values.size()));
  std::vector<Value> repeated;
  for (auto first = values.begin(); first != values.end();) {
    const auto last = std::upper_bound(first, values.end(), *first);
    if (static_cast<double>(last - first) >= fewest) {
      repeated.push_back(*first);
    }
    first = last;
  }
  return repeated;
}

}  // namespace

std::size_t mask_invalid_points(Points& points_sensor, InvalidPoints kind) {
  std::vector<Value> invalid{{0.0F, 0.0F, 0.0F}};
  if (kind == InvalidPoints::kAlsoRepeated) {
    const std::vector<Value> repeated = repeated_values(points_sensor);
    invalid.insert(invalid.end(), repeated.begin(), repeated.end());
  }
  std::size_t num_masked = 0;
  for (Eigen::Index i = 0; i < points_sensor.rows(); ++i) {
    if (std::find(invalid.begin(), invalid.end(), value_of(points_sensor, i)) != invalid.end()) {
      points_sensor.row(i).setConstant(std::numeric_limits<float>::quiet_NaN());
      ++num_masked;
    }
  }
  return num_masked;
}

}  // namespace rigidformer_ros
