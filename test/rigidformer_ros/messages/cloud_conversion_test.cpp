// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/cloud_conversion.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>

#include "rigidformer/geometry/point_rows.hpp"

namespace rigidformer_ros {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

// Limit given to read_points(): more than all clouds of this file have, and small enough to be exceeded by bad sizes.
constexpr std::uint64_t kMaxPoints = 1000;

Points three_points() {
  Points points(3, 3);
  points << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  return points;
}

std::string error_of(const PointCloud2& cloud) {
  try {
    read_points(cloud, kMaxPoints);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CloudConversion, RoundTripIsExact) {
  EXPECT_EQ(read_points(to_cloud(three_points()), kMaxPoints), three_points());
}

TEST(CloudConversion, P04_ReadsDoublesOtherFieldsAndPaddedRows) {
  PointCloud2 cloud;
  cloud.width = 1;
  cloud.height = 2;
  cloud.point_step = 40;
  cloud.row_step = 50;
  const char* const names[] = {"intensity", "z", "y", "x"};
  for (int i = 0; i < 4; ++i) {
    PointField field;
    field.name = names[i];
    field.offset = static_cast<std::uint32_t>(8 * i);
    field.datatype = PointField::FLOAT64;
    field.count = 1;
    cloud.fields.push_back(field);
  }
  cloud.data.resize(50 + 40);  // The last row has no padding behind its point.
  for (int row = 0; row < 2; ++row) {
    const double values[] = {99.0, 3.0 + row, 2.0 + row, 1.0 + row};
    std::memcpy(cloud.data.data() + 50 * row, values, sizeof(values));
  }
  Points expected(2, 3);
  expected << 1, 2, 3, 2, 3, 4;
  EXPECT_EQ(read_points(cloud, kMaxPoints), expected);
}

TEST(CloudConversion, P01_UnusableCoordinatesBecomeNanWhateverIsDenseSays) {
  Points points = three_points();
  points(0, 1) = std::numeric_limits<float>::quiet_NaN();
  points(1, 2) = -std::numeric_limits<float>::infinity();
  PointCloud2 cloud = to_cloud(points);
  cloud.is_dense = true;
  EXPECT_EQ(rigidformer::finite_rows(read_points(cloud, kMaxPoints)), std::vector<int>({2}));
  points(2, 0) = 1e30F;
  EXPECT_TRUE(read_points(to_cloud(points), kMaxPoints).array().isNaN().all());
}

TEST(CloudConversion, P03_AcceptsEmptyCloudsAndPackedDataWithoutRowStep) {
  EXPECT_EQ(read_points(PointCloud2(), kMaxPoints).rows(), 0);
  PointCloud2 empty_rows;
  empty_rows.height = 0xffffffff;
  EXPECT_EQ(read_points(empty_rows, kMaxPoints).rows(), 0);
  PointCloud2 cloud = to_cloud(three_points());
  cloud.row_step = 0;
  EXPECT_EQ(read_points(cloud, kMaxPoints), three_points());
}

TEST(CloudConversion, P03_MalformedMessagesNameTheField) {
  const std::pair<const char*, std::function<void(PointCloud2&)>> cases[] = {
      {"row_step", [](PointCloud2& c) { c.row_step = 12; }},
      {"row_step", [](PointCloud2& c) { c.row_step = 0, c.data.pop_back(); }},
      {"data", [](PointCloud2& c) { c.data.pop_back(); }},
      {"data", [](PointCloud2& c) { c.data.clear(); }},
      {"width x height", [](PointCloud2& c) { c.width = c.height = 0xffffffff; }},
      {"width x height", [](PointCloud2& c) { c.width = 0x10000, c.height = 0x10000; }},
      {"fields['x'].offset", [](PointCloud2& c) { c.point_step = 0; }},
      {"fields['z'].offset", [](PointCloud2& c) { c.fields[2].offset = 9; }},
      {"fields['y'].offset", [](PointCloud2& c) { c.fields[1].offset = 0xffffffff; }},
      {"no field 'x'", [](PointCloud2& c) { c.fields[0].name = "u"; }},
      {"no field 'x'", [](PointCloud2& c) { c.fields.clear(); }},
      {"fields['x'].datatype", [](PointCloud2& c) { c.fields[0].datatype = PointField::INT16; }},
      {"one type", [](PointCloud2& c) { c.fields[1].datatype = PointField::FLOAT64; }},
      {"one type", [](PointCloud2& c) { c.fields[1].count = 3; }},
      {"is_bigendian", [](PointCloud2& c) { c.is_bigendian = true; }}};
  for (const auto& [part, damage] : cases) {
    PointCloud2 cloud = to_cloud(three_points());
    damage(cloud);
    EXPECT_NE(error_of(cloud).find(part), std::string::npos) << "'" << error_of(cloud) << "' lacks '" << part << "'";
  }
}

TEST(CloudConversion, P55_FinitePointsCountNotTheImage) {
  Points image = Points::Constant(1000, 3, std::numeric_limits<float>::quiet_NaN());
  image.topRows(3) = three_points();
  EXPECT_EQ(read_points(to_cloud(image), {3, "input/max_points"}).rows(), 1000);
  try {
    read_points(to_cloud(image), {2, "input/max_points"});
    FAIL() << "three finite points are more than two";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("input/max_points"), std::string::npos) << error.what();
  }
}

TEST(CloudConversion, LabelledCloudHoldsEveryBatch) {
  const PointCloud2 cloud = to_labelled_cloud({{three_points(), 4, 1, 0.25F}, {three_points(), 5, 2, 0.5F}});
  ASSERT_EQ(cloud.width, 6U);
  ASSERT_EQ(cloud.fields.size(), 6U);
  EXPECT_EQ(read_points(cloud, kMaxPoints).bottomRows(3), three_points());
  std::uint32_t label = 0;
  float time_s = 0.0F;
  std::memcpy(&label, cloud.data.data() + 5 * cloud.point_step + cloud.fields[3].offset, 4);
  std::memcpy(&time_s, cloud.data.data() + 5 * cloud.point_step + cloud.fields[5].offset, 4);
  EXPECT_EQ(label, 5U);
  EXPECT_EQ(time_s, 0.5F);
}

}  // namespace
}  // namespace rigidformer_ros
