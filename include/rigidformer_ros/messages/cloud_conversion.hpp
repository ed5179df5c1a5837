// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer_ros {

/// The core's matrix of points: one row of x, y, z [m] per point.
using rigidformer::Points;

/// How many points of a cloud may be finite, and the name of the parameter that says so.
struct PointLimit {
  PointLimit(std::uint64_t most, const char* parameter = "max_points") : points(most), name(parameter) {}
  std::uint64_t points;  ///< Largest number of finite points
  const char* name;      ///< Name of the parameter, for the text of an error
};

/// Reads the fields x, y and z [m] of every point, as float32 or float64, in the order of the message. The cloud may
/// have any other fields. A point with a coordinate that is not finite or larger than 1e8 m becomes NaN, whatever
/// `is_dense` claims; its row stays, so that row numbers are point numbers. Throws std::invalid_argument naming the
/// field at fault when the message contradicts itself or has more finite points than `limit`. The function never reads
/// outside `data`.
Points read_points(const sensor_msgs::PointCloud2& cloud, const PointLimit& limit);

/// Throws std::invalid_argument when more points [N, 3] are finite than `limit` says.
void require_few(const Points& points, const PointLimit& limit);

/// The points of one object at one predicted step, as they go into a labelled cloud.
struct LabelledPoints {
  Points points;            ///< Positions [N, 3] m
  std::uint32_t label = 0;  ///< Value of the field `label` of all these points
  std::uint32_t step = 0;   ///< Value of the field `step` of all these points
  float time_s = 0.0F;      ///< Value of the field `t` [s] of all these points
};

/// Makes a cloud with the fields x, y and z [m] as float32. The caller fills in the header.
sensor_msgs::PointCloud2 to_cloud(const Points& points);

/// Makes one cloud of all batches with the fields x, y, z [m], label, step and t [s]. The caller fills in the header.
sensor_msgs::PointCloud2 to_labelled_cloud(const std::vector<LabelledPoints>& batches);

}  // namespace rigidformer_ros
