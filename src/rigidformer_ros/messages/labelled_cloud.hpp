// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <vector>

#include "rigidformer_ros/messages/cloud_conversion.hpp"

namespace rigidformer_ros {

/// The points of one label, in the order of the cloud. Rows that are not finite stay, as NaN.
struct LabelPoints {
  std::uint32_t label = 0;
  Points points;  ///< [N, 3] m
};

/// Splits a cloud by its integer field `label` or, without one, `instance` (8, 16 or 32 bits, signed or not), in the
/// order of the labels. Labels up to 0 are background and left out. Throws std::invalid_argument like read_points(),
/// and naming the field when there is none of a usable type or more than 256 labels.
std::vector<LabelPoints> split_by_label(const sensor_msgs::PointCloud2& cloud, std::uint64_t max_points);

}  // namespace rigidformer_ros
