// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/cloud_conversion.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "rigidformer/geometry/point_rows.hpp"

namespace rigidformer_ros {

namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

constexpr double kLargestCoordinate = 1e8;  // [m] no place on Earth has a larger one in any frame

// Where the coordinates lie in the data. The sizes [bytes] are held in 64 bits so that products of them fit.
struct Layout {
  std::uint64_t width;
  std::uint64_t height;
  std::uint64_t point_step;
  std::uint64_t row_step;
  std::uint32_t offsets[3];
  bool double_precision;
};

std::uint64_t size_of(std::uint8_t datatype) { return datatype == PointField::FLOAT64 ? 8 : 4; }

const PointField& find_field(const PointCloud2& cloud, const std::string& name) {
  for (const PointField& field : cloud.fields) {
    if (field.name == name) {
      return field;
    }
  }
  throw std::invalid_argument("fields: no field '" + name + "'");
}

void read_field_layout(const PointCloud2& cloud, Layout& layout) {
  const char* const names[] = {"x", "y", "z"};
  const std::uint8_t datatype = find_field(cloud, "x").datatype;
  for (int axis = 0; axis < 3; ++axis) {
    const PointField& field = find_field(cloud, names[axis]);
    const std::string label = std::string("fields['") + names[axis] + "']";
    if (field.datatype != PointField::FLOAT32 && field.datatype != PointField::FLOAT64) {
      throw std::invalid_argument(label + ".datatype: is " + std::to_string(field.datatype) +
                                  ", must be FLOAT32 (7) or FLOAT64 (8)");
    }
    if (field.datatype != datatype || field.count > 1) {
      throw std::invalid_argument(label + ": x, y and z must be single values of one type");
    }
    if (static_cast<std::uint64_t>(field.offset) + size_of(datatype) > layout.point_step) {
      throw std::invalid_argument(label + ".offset: " + std::to_string(field.offset) + " reaches past point_step " +
                                  std::to_string(layout.point_step));
    }
    layout.offsets[axis] = field.offset;
  }
  layout.double_precision = datatype == PointField::FLOAT64;
}

// All products are taken in 64 bits: each factor is below 2^32.
Layout read_layout(const PointCloud2& cloud) {
  Layout layout{cloud.width, cloud.height, cloud.point_step, cloud.row_step, {0, 0, 0}, false};
  const std::uint64_t count = layout.width * layout.height;
  if (count == 0) {
    return {};  // A layout without rows: a message may claim four billion empty rows, which would keep the reader busy.
  }
  if (cloud.is_bigendian) {
    throw std::invalid_argument("is_bigendian: big-endian data is not supported");
  }
  read_field_layout(cloud, layout);
  if (count > cloud.data.size()) {
    throw std::invalid_argument("width x height: " + std::to_string(count) + " points do not fit into " +
                                std::to_string(cloud.data.size()) + " bytes of data");
  }
  const std::uint64_t packed_row = layout.width * layout.point_step;
  if (layout.row_step == 0 && cloud.data.size() == packed_row * layout.height) {
    layout.row_step = packed_row;  // Some drivers leave row_step at 0 when the data is packed.
  }
  if (layout.row_step < packed_row) {
    throw std::invalid_argument("row_step: is " + std::to_string(layout.row_step) + ", width x point_step is " +
                                std::to_string(packed_row));
  }
  const std::uint64_t needed = (layout.height - 1) * layout.row_step + packed_row;
  if (cloud.data.size() < needed) {
    throw std::invalid_argument("data: has " + std::to_string(cloud.data.size()) + " bytes, the layout needs " +
                                std::to_string(needed));
  }
  return layout;
}

template <typename Scalar>
float read_coordinate(const std::uint8_t* bytes) {
  Scalar value;
  std::memcpy(&value, bytes, sizeof(value));
  const bool usable = std::abs(static_cast<double>(value)) <= kLargestCoordinate;  // NaN compares false.
  return usable ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN();
}

template <typename Scalar>
Points read_rows(const PointCloud2& cloud, const Layout& layout) {
  Points points(static_cast<Eigen::Index>(layout.width * layout.height), 3);
  Eigen::Index index = 0;
  for (std::uint64_t row = 0; row < layout.height; ++row) {
    for (std::uint64_t column = 0; column < layout.width; ++column, ++index) {
      const std::uint8_t* point = cloud.data.data() + row * layout.row_step + column * layout.point_step;
      for (int axis = 0; axis < 3; ++axis) {
        points(index, axis) = read_coordinate<Scalar>(point + layout.offsets[axis]);
      }
      if (!points.row(index).allFinite()) {
        points.row(index).setConstant(std::numeric_limits<float>::quiet_NaN());
      }
    }
  }
  return points;
}

void add_field(PointCloud2& cloud, const std::string& name, std::uint8_t datatype) {
  PointField field;
  field.name = name;
  field.offset = cloud.point_step;
  field.datatype = datatype;
  field.count = 1;
  cloud.fields.push_back(field);
  cloud.point_step += 4;
}

PointCloud2 make_cloud(std::size_t count, bool labelled) {
  PointCloud2 cloud;
  for (const char* name : {"x", "y", "z"}) {
    add_field(cloud, name, PointField::FLOAT32);
  }
  if (labelled) {
    add_field(cloud, "label", PointField::UINT32);
    add_field(cloud, "step", PointField::UINT32);
    add_field(cloud, "t", PointField::FLOAT32);
  }
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(count);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = true;
  cloud.data.resize(static_cast<std::size_t>(cloud.row_step));
  return cloud;
}

}  // namespace

Points read_points(const PointCloud2& cloud, const PointLimit& limit) {
  const Layout layout = read_layout(cloud);
  Points points = layout.double_precision ? read_rows<double>(cloud, layout) : read_rows<float>(cloud, layout);
  require_few(points, limit);
  return points;
}

void require_few(const Points& points, const PointLimit& limit) {
  const std::size_t num_finite = rigidformer::finite_rows(points).size();
  if (num_finite > limit.points) {
    throw std::invalid_argument("has " + std::to_string(num_finite) + " finite points, " + limit.name +
                                " accepts at most " + std::to_string(limit.points));
  }
}

PointCloud2 to_cloud(const Points& points) {
  PointCloud2 cloud = make_cloud(static_cast<std::size_t>(points.rows()), /*labelled=*/false);
  if (points.size() > 0) {
    std::memcpy(cloud.data.data(), points.data(), cloud.data.size());
  }
  return cloud;
}

PointCloud2 to_labelled_cloud(const std::vector<LabelledPoints>& batches) {
  std::size_t count = 0;
  for (const LabelledPoints& batch : batches) {
    count += static_cast<std::size_t>(batch.points.rows());
  }
  PointCloud2 cloud = make_cloud(count, /*labelled=*/true);
  std::uint8_t* out = cloud.data.data();
  for (const LabelledPoints& batch : batches) {
    for (Eigen::Index i = 0; i < batch.points.rows(); ++i, out += cloud.point_step) {
      std::memcpy(out, batch.points.row(i).data(), 12);
      std::memcpy(out + 12, &batch.label, 4);
      std::memcpy(out + 16, &batch.step, 4);
      std::memcpy(out + 20, &batch.time_s, 4);
    }
  }
  return cloud;
}

}  // namespace rigidformer_ros
