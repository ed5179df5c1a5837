// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer_ros::testing {

/// Writes clouds with a label per point for tests. The members choose the layout, so that the label can stand before or
/// behind x y z. Offsets and the step from point to point are in bytes.
struct LabelledCloudMaker {
  std::string field = "label";
  std::uint8_t datatype = sensor_msgs::PointField::UINT32;
  std::uint32_t label_offset = 16;
  std::uint32_t xyz_offset = 0;
  std::uint32_t point_step = 24;

  sensor_msgs::PointCloud2 make(const rigidformer::Points& points, const std::vector<std::int64_t>& labels) const {
    sensor_msgs::PointCloud2 cloud;
    add_field(cloud, field, label_offset, datatype);
    const char* const axes[] = {"x", "y", "z"};
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      add_field(cloud, axes[axis], xyz_offset + 4 * axis, sensor_msgs::PointField::FLOAT32);
    }
    cloud.height = 1;
    cloud.width = static_cast<std::uint32_t>(points.rows());
    cloud.point_step = point_step;
    cloud.row_step = cloud.width * point_step;
    cloud.data.resize(cloud.row_step);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      std::uint8_t* point = cloud.data.data() + static_cast<std::size_t>(i) * point_step;
      std::memcpy(point + xyz_offset, points.row(i).data(), 12);
      // On a little-endian machine the first bytes of a number are the same number in a smaller type.
      std::memcpy(point + label_offset, &labels.at(static_cast<std::size_t>(i)), label_size());
    }
    return cloud;
  }

 private:
  std::size_t label_size() const { return datatype <= 2 ? 1 : datatype <= 4 ? 2 : 4; }

  static void add_field(sensor_msgs::PointCloud2& cloud, const std::string& name, std::uint32_t offset,
                        std::uint8_t datatype) {
    sensor_msgs::PointField member;
    member.name = name;
    member.offset = offset;
    member.datatype = datatype;
    member.count = 1;
    cloud.fields.push_back(member);
  }
};

}  // namespace rigidformer_ros::testing
