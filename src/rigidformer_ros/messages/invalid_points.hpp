// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer_ros {

/// Drivers write a number instead of NaN for pixels without depth.
enum class InvalidPoints {
  kAtOrigin,     ///< Points at exactly the sensor's origin are none
  kAlsoRepeated  ///< Nor are those of one exact value that many pixels share, such as the end of the measuring range
};

/// Turns points [N, 3] of the sensor's frame that are none into NaN, so that point numbers stay the same. Returns how
/// many there were.
std::size_t mask_invalid_points(rigidformer::Points& points_sensor, InvalidPoints kind);

}  // namespace rigidformer_ros
