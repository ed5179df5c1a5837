// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/labelled_cloud.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "rigidformer/geometry/point_rows.hpp"

namespace rigidformer_ros {

namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

// Most labels of one cloud; chosen by eye. A field with more values numbers something else than objects.
constexpr std::size_t kMostLabels = 256;

std::uint64_t size_of(std::uint8_t datatype) {
  switch (datatype) {
    case PointField::INT8:
    case PointField::UINT8:
      return 1;
    case PointField::INT16:
    case PointField::UINT16:
      return 2;
    case PointField::INT32:
    case PointField::UINT32:
      return 4;
    default:
      return 0;
  }
}

// A segmentation that publishes both fields writes the class into `label` and the number of the object into `instance`.
const PointField& find_label_field(const PointCloud2& cloud, const std::string& wanted) {
  const std::vector<std::string> names =
      wanted.empty() ? std::vector<std::string>{"instance", "label"} : std::vector<std::string>{wanted};
  for (const std::string& name : names) {
    const auto found = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                    [&](const PointField& field) { return field.name == name; });
    if (found != cloud.fields.end()) {
      return *found;
    }
  }
  throw std::invalid_argument(wanted.empty()
                                  ? "fields: no field 'instance' or 'label' (input/label_field names another)"
                                  : "fields: no field '" + wanted + "' (input/label_field)");
}

void check(const PointField& field, std::uint32_t point_step) {
  const std::string name = "fields['" + field.name + "']";
  if (size_of(field.datatype) == 0) {
    throw std::invalid_argument(name + ".datatype: is " + std::to_string(field.datatype) +
                                ", must be an integer of 8, 16 or 32 bits (1 to 6)");
  }
  if (field.count > 1) {
    throw std::invalid_argument(name + ".count: is " + std::to_string(field.count) + ", must be 1");
  }
  if (field.offset + size_of(field.datatype) > point_step) {
    throw std::invalid_argument(name + ".offset: " + std::to_string(field.offset) + " reaches past point_step " +
                                std::to_string(point_step));
  }
}

template <typename Integer>
std::int64_t read_integer(const std::uint8_t* bytes) {
  Integer value;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

// The labels of no object in a field of this type. Segmenters write -1 into unsigned fields as well, for "no segment":
// there it is 255, 65535 or 4294967295.
std::set<std::int64_t> background_of(const std::vector<int>& labels, std::uint8_t datatype) {
  std::set<std::int64_t> background(labels.begin(), labels.end());
  if (background.count(-1) > 0) {
    background.insert((std::int64_t{1} << (8 * size_of(datatype))) - 1);
  }
  return background;
}

std::int64_t read_label(const std::uint8_t* bytes, std::uint8_t datatype) {
  switch (datatype) {
    case PointField::INT8:
      return read_integer<std::int8_t>(bytes);
    case PointField::UINT8:
      return read_integer<std::uint8_t>(bytes);
    case PointField::INT16:
      return read_integer<std::int16_t>(bytes);
    case PointField::UINT16:
      return read_integer<std::uint16_t>(bytes);
    case PointField::INT32:
      return read_integer<std::int32_t>(bytes);
    default:
      return read_integer<std::uint32_t>(bytes);
  }
}

// Lists the row numbers of the points of each label. The caller must have checked the layout of the cloud.
std::map<std::uint32_t, std::vector<int>> rows_by_label(const PointCloud2& cloud, const PointField& field,
                                                        const std::set<std::int64_t>& background) {
  const std::uint64_t point_step = cloud.point_step;
  const std::uint64_t row_step = cloud.row_step > 0 ? cloud.row_step : cloud.width * point_step;
  std::map<std::uint32_t, std::vector<int>> rows;
  int index = 0;
  for (std::uint64_t row = 0; row < cloud.height; ++row) {
    for (std::uint64_t column = 0; column < cloud.width; ++column, ++index) {
      const std::uint8_t* point = cloud.data.data() + row * row_step + column * point_step;
      const std::int64_t label = read_label(point + field.offset, field.datatype);
      if (label < 0 || background.count(label) > 0) {
        continue;
      }
      rows[static_cast<std::uint32_t>(label)].push_back(index);
      if (rows.size() > kMostLabels) {
        throw std::invalid_argument("fields['" + field.name + "']: more than " + std::to_string(kMostLabels) +
                                    " different labels");
      }
    }
  }
  return rows;
}

}  // namespace

std::vector<LabelPoints> split_by_label(const PointCloud2& cloud, const Points& points, const LabelOptions& options) {
  if (points.rows() == 0) {
    return {};
  }
  const PointField& field = find_label_field(cloud, options.field);
  check(field, cloud.point_step);
  std::vector<LabelPoints> parts;
  for (const auto& [label, rows] :
       rows_by_label(cloud, field, background_of(options.background_labels, field.datatype))) {
    parts.push_back({label, rigidformer::select_rows(points, rows)});
  }
  return parts;
}

}  // namespace rigidformer_ros
