// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <string>

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/tracking/observation.hpp"

namespace rigidformer::testing {

/// An irregular cloud of about a metre, the size that the shipped model knows. It is the same every time,
/// and its centroid is the origin.
inline Points blob(int count = 30, unsigned seed = 7) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> coordinate(-0.5F, 0.5F);
  Points points = Points::NullaryExpr(count, 3, [&] { return coordinate(generator); });
  if (count > 0) {
    points.rowwise() -= points.colwise().mean().eval();
  }
  return points;
}

/// A body in free fall with constant spin about a fixed axis.
struct Flight {
  Eigen::Vector3d start{0.0, 0.0, 2.0};
  Eigen::Vector3d velocity{0.5, -0.2, 1.0};
  Eigen::Vector3d angular_velocity{0.3, 1.0, -2.0};
  double gravity = -10.0;

  RigidTransform pose(double t) const {
    const double rate = angular_velocity.norm();
    const Eigen::Quaterniond turn = rate > 0.0
                                        ? Eigen::Quaterniond(Eigen::AngleAxisd(rate * t, angular_velocity / rate))
                                        : Eigen::Quaterniond(1, 0, 0, 0);
    return {turn, start + velocity * t + Eigen::Vector3d(0.0, 0.0, 0.5 * gravity * t * t)};
  }
};

inline ObjectObservation observe(const std::string& id, const Points& points, double stamp_s) {
  ObjectObservation observation;
  observation.id = id;
  observation.stamp = stamp_at(stamp_s);
  observation.points_world = points;
  return observation;
}

inline ObjectObservation observe(const std::string& id, const Flight& flight, double stamp_s, double t) {
  return observe(id, flight.pose(t).apply(blob()), stamp_s);
}

}  // namespace rigidformer::testing
