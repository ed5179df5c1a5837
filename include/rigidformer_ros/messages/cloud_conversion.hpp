// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer_ros {

using rigidformer::Points;

/// How many points of a cloud may be finite, and the parameter that says so.
struct PointLimit {
  PointLimit(std::uint64_t most, const char* parameter = "max_points") : points(most), name(parameter) {}
  std::uint64_t points;
  const char* name;
};

/// Reads x, y, z [m] (float32 or float64) of every point, in order, whatever other fields there are. Coordinates that
/// are not finite or absurdly large (> 1e6 m) become NaN, whatever `is_dense` claims, so that point numbers stay the
/// same. Throws std::invalid_argument naming the field at fault when the message contradicts itself or has more
/// finite points than `limit`; never reads outside `data`.
Points read_points(const sensor_msgs::PointCloud2& cloud, const PointLimit& limit);

/// Throws std::invalid_argument when more points are finite than `limit` says.
void require_few(const Points& points, const PointLimit& limit);

/// One batch of points of a labelled cloud.
struct LabelledPoints {
  Points points;
  std::uint32_t label = 0;
  std::uint32_t step = 0;
  float time_s = 0.0F;
};

/// Cloud with x y z [m]. The header is left to the caller.
sensor_msgs::PointCloud2 to_cloud(const Points& points);

/// Cloud with x y z [m], label, step, t [s]. The header is left to the caller.
sensor_msgs::PointCloud2 to_labelled_cloud(const std::vector<LabelledPoints>& batches);

}  // namespace rigidformer_ros
