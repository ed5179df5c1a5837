// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <vector>

#include "rigidformer_ros/messages/cloud_conversion.hpp"

namespace rigidformer_ros {

/// The points of one label, in the order of the cloud. A point that is not finite keeps its row, as NaN.
struct LabelPoints {
  std::uint32_t label = 0;  ///< Value of the label field, 1 or more
  Points points;            ///< Positions [N, 3] m
};

/// Splits a cloud by its integer field `label` or, if there is none, by its field `instance`. The field may have 8, 16
/// or 32 bits, with or without a sign. The parts are in the order of the labels. Labels of 0 and less mean background,
/// whose points are left out. Throws std::invalid_argument as read_points() does, and also when neither field exists,
/// when the field has no usable type, or when it has more than 256 different labels; the message names the field.
std::vector<LabelPoints> split_by_label(const sensor_msgs::PointCloud2& cloud, std::uint64_t max_points);

}  // namespace rigidformer_ros
