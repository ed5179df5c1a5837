// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "rigidformer/geometry/random.hpp"

namespace rigidformer {

/// An interval to draw from.
struct Range {
  double low, high;
};

inline double draw(Random& random, Range range) { return random.uniform(range.low, range.high); }

/// Uniform in the logarithm.
inline double draw_magnitude(Random& random, Range range) {
  return std::exp(random.uniform(std::log(range.low), std::log(range.high)));
}

inline bool draw_chance(Random& random, double probability) { return random.uniform(0.0, 1.0) < probability; }

/// A level direction.
inline Eigen::Vector3d draw_direction(Random& random) {
  const double angle_rad = random.uniform(0.0, 2.0 * M_PI);
  return {std::cos(angle_rad), std::sin(angle_rad), 0.0};
}

}  // namespace rigidformer
