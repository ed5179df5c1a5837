// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/near_origin.hpp"

#include <sstream>
#include <stdexcept>
#include <vector>

#include "rigidformer/geometry/point_rows.hpp"

namespace rigidformer_ros {

namespace {

// Two numbers of single precision near 10 km differ by 1 mm, which is what tracking needs.
constexpr double kFarthest_m = 10000.0;

}  // namespace

void require_near_origin(const rigidformer::Points& points_world, const std::string& fixed_frame) {
  const std::vector<int> rows = rigidformer::finite_rows(points_world);
  if (rows.empty()) {
    return;
  }
  // One point of the cloud tells where it lies; a single stray point must not.
  const Eigen::RowVector3f place = points_world.row(rows[rows.size() / 2]);
  if (place.cast<double>().norm() > kFarthest_m) {
    std::ostringstream text;
    text.precision(9);
    text << "lies at (" << place.x() << ", " << place.y() << ", " << place.z() << ") m of '" << fixed_frame
         << "', farther than " << kFarthest_m << " m from its origin, where single precision no longer resolves "
         << "millimetres; choose a fixed_frame near the robot, such as odom";
    throw std::invalid_argument(text.str());
  }
}

}  // namespace rigidformer_ros
