// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <string>
#include <vector>

#include "rigidformer_ros/messages/cloud_conversion.hpp"

namespace rigidformer_ros {

/// The points of one label, in the order of the cloud. A point that is not finite keeps its row, as NaN.
struct LabelPoints {
  std::uint32_t label = 0;  ///< Value of the label field, 1 or more
  Points points;            ///< Positions [N, 3] m
};

/// How a cloud says which object a point belongs to.
struct LabelOptions {
  std::string field;                             ///< Name of the field; "" = `instance`, without it `label`
  std::vector<int> background_labels = {-1, 0};  ///< Of no object; -1 = all bits set, as in 255 of an 8-bit field
};

/// Splits a cloud by an integer field of 8, 16 or 32 bits, signed or not, in the order of the labels. Background and
/// negative labels are left out. `points` are those of read_points(). Throws std::invalid_argument naming the field
/// when there is none of a usable type or more than 256 labels.
std::vector<LabelPoints> split_by_label(const sensor_msgs::PointCloud2& cloud, const Points& points,
                                        const LabelOptions& options = {});

}  // namespace rigidformer_ros
