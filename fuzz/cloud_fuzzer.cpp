// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <fuzzer/FuzzedDataProvider.h>

#include <stdexcept>

#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/messages/invalid_points.hpp"
#include "rigidformer_ros/messages/labelled_cloud.hpp"
#include "rigidformer_ros/messages/near_origin.hpp"

namespace {

constexpr std::uint64_t kMaxPoints = 4096;  // points of a cloud, so that every run is short; chosen by eye

// Draws mostly the numbers that real messages hold: random ones alone would hardly ever fit each other.
std::uint32_t count(FuzzedDataProvider& bytes) {
  return bytes.ConsumeBool() ? bytes.ConsumeIntegralInRange<std::uint32_t>(0, 64)
                             : bytes.ConsumeIntegral<std::uint32_t>();
}

sensor_msgs::PointCloud2 make_cloud(FuzzedDataProvider& bytes) {
  sensor_msgs::PointCloud2 cloud;
  cloud.width = count(bytes);
  cloud.height = count(bytes);
  cloud.point_step = count(bytes);
  cloud.row_step = bytes.ConsumeBool() ? cloud.width * cloud.point_step : count(bytes);
  cloud.is_bigendian = bytes.ConsumeIntegralInRange<int>(0, 15) == 15;
  cloud.is_dense = bytes.ConsumeBool();
  const auto num_fields = bytes.ConsumeIntegralInRange<std::size_t>(0, 6);
  for (std::size_t i = 0; i < num_fields; ++i) {
    sensor_msgs::PointField field;
    field.name = bytes.PickValueInArray({"x", "y", "z", "label", "instance", ""});
    field.offset = count(bytes);
    field.datatype = bytes.ConsumeIntegralInRange<std::uint8_t>(0, 9);
    field.count = bytes.ConsumeBool() ? 1 : count(bytes);
    cloud.fields.push_back(field);
  }
  cloud.data = bytes.ConsumeRemainingBytes<std::uint8_t>();
  return cloud;
}

// Every point belongs to at most one label.
void check_labels(const sensor_msgs::PointCloud2& cloud, const rigidformer_ros::Points& points) {
  Eigen::Index num_labelled = 0;
  for (const rigidformer_ros::LabelPoints& part : rigidformer_ros::split_by_label(cloud, points)) {
    num_labelled += part.points.rows();
  }
  if (num_labelled > points.rows()) {
    __builtin_trap();
  }
}

}  // namespace

/// Checks that every accepted cloud gives one row per point, finite or NaN as a whole.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  const sensor_msgs::PointCloud2 cloud = make_cloud(bytes);
  try {
    rigidformer_ros::Points points = rigidformer_ros::read_points(cloud, kMaxPoints);
    if (points.rows() != static_cast<Eigen::Index>(cloud.width) * static_cast<Eigen::Index>(cloud.height)) {
      __builtin_trap();
    }
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      if (!points.row(i).allFinite() && !points.row(i).array().isNaN().all()) {
        __builtin_trap();
      }
    }
    rigidformer_ros::mask_invalid_points(points, rigidformer_ros::InvalidPoints::kAlsoRepeated);
    rigidformer_ros::require_near_origin(points, "world");
    check_labels(cloud, points);
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
