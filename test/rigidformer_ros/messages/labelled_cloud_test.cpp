// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/messages/labelled_cloud.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer_ros/labelled_cloud_maker.hpp"
#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;
using testing::blob;
using testing::LabelledCloudMaker;

// Limit given to split_by_label(): more points than all good clouds of this file have.
constexpr std::uint64_t kMaxPoints = 1000;
// One label per point of the six points that most tests split: two of background, one of object 2, three of object 7.
const std::vector<std::int64_t> kLabels{0, 7, 2, 7, 0, 7};

std::vector<LabelPoints> split(const PointCloud2& cloud, const LabelOptions& options = {}) {
  return split_by_label(cloud, read_points(cloud, kMaxPoints), options);
}

void expect_split(const PointCloud2& cloud, const Points& points) {
  const std::vector<LabelPoints> parts = split(cloud);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].label, 2U);
  EXPECT_EQ(parts[1].label, 7U);
  EXPECT_EQ(parts[0].points, rigidformer::select_rows(points, {2}));
  EXPECT_EQ(parts[1].points, rigidformer::select_rows(points, {1, 3, 5}));
}

std::string error_of(const PointCloud2& cloud) {
  try {
    split(cloud);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(LabelledCloud, ReadsEveryIntegerTypeAndFieldOrder) {
  const Points points = blob(6);
  for (const std::uint8_t datatype : {PointField::INT8, PointField::UINT8, PointField::INT16, PointField::UINT16,
                                      PointField::INT32, PointField::UINT32}) {
    LabelledCloudMaker maker;
    maker.datatype = datatype;
    expect_split(maker.make(points, kLabels), points);
    maker.field = "instance";
    maker.label_offset = 1;  // The label stands before x y z, at an address that is not aligned.
    maker.xyz_offset = 5;
    expect_split(maker.make(points, kLabels), points);
  }
}

TEST(LabelledCloud, P54_InstanceWinsOverLabelAndANameOverBoth) {
  const Points points = blob(6);
  LabelledCloudMaker maker;
  maker.field = "instance";
  PointCloud2 cloud = maker.make(points, kLabels);
  PointField other = cloud.fields[0];
  other.name = "label";
  other.offset = 0;  // These are the bytes of x: read as labels, they would make other objects.
  cloud.fields.insert(cloud.fields.begin(), other);
  expect_split(cloud, points);
  cloud.fields[0].name = "instance";
  cloud.fields[1].name = "object_id";
  const std::vector<LabelPoints> named = split(cloud, {"object_id", {0}});
  ASSERT_EQ(named.size(), 2U);
  EXPECT_EQ(named[1].label, 7U);
  EXPECT_THROW(split(cloud, {"nothing", {0}}), std::invalid_argument);
}

TEST(LabelledCloud, P54_AllBitsAndListedLabelsAreBackground) {
  const Points points = blob(3);
  LabelledCloudMaker maker;
  for (const auto& [datatype, all_bits] : {std::pair<std::uint8_t, std::int64_t>{PointField::UINT8, 255},
                                           {PointField::UINT16, 65535},
                                           {PointField::UINT32, 4294967295}}) {
    maker.datatype = datatype;
    const PointCloud2 cloud = maker.make(points, {all_bits, 3, 5});
    EXPECT_EQ(split(cloud).size(), 2U) << all_bits;
    EXPECT_EQ(split(cloud, {"", {0, 5}}).size(), 2U) << all_bits;
    EXPECT_EQ(split(cloud, {"", {-1, 0, 5}}).size(), 1U) << all_bits;
  }
}

TEST(LabelledCloud, OrganisedCloudsMayHavePaddedRows) {
  const Points points = blob(6);
  const PointCloud2 flat = LabelledCloudMaker().make(points, kLabels);
  PointCloud2 organised = flat;
  organised.height = 2;
  organised.width = 3;
  organised.row_step = 3 * flat.point_step + 10;
  organised.data.assign(2 * organised.row_step, 0xAB);
  for (std::uint32_t row = 0; row < 2; ++row) {
    std::copy_n(flat.data.begin() + row * 3 * flat.point_step, 3 * flat.point_step,
                organised.data.begin() + row * organised.row_step);
  }
  expect_split(organised, points);
}

TEST(LabelledCloud, NegativeLabelsAreBackgroundAndLargeOnesAreKept) {
  const Points points = blob(3);
  LabelledCloudMaker maker;
  EXPECT_EQ(split(maker.make(points, {4000000000, 0, 0})).at(0).label, 4000000000U);
  for (const std::uint8_t datatype : {PointField::INT8, PointField::INT16, PointField::INT32}) {
    maker.datatype = datatype;
    EXPECT_TRUE(split(maker.make(points, {-1, -1, -1})).empty());
  }
}

TEST(LabelledCloud, P01_NotFinitePointsKeepTheirPlace) {
  Points points = blob(6);
  points(3, 1) = std::numeric_limits<float>::infinity();
  const std::vector<LabelPoints> parts = split(LabelledCloudMaker().make(points, kLabels));
  ASSERT_EQ(parts.at(1).points.rows(), 3);
  EXPECT_EQ(rigidformer::finite_rows(parts.at(1).points), (std::vector<int>{0, 2}));
}

TEST(LabelledCloud, P02_EmptyAndAllBackgroundHaveNoObjects) {
  EXPECT_TRUE(split(PointCloud2()).empty());
  EXPECT_TRUE(split(LabelledCloudMaker().make(blob(6), {0, 0, 0, 0, 0, 0})).empty());
}

struct Damage {
  const char* expected;
  std::function<void(PointCloud2&)> apply;
};

TEST(LabelledCloud, P03_MalformedTablesAreNamed) {
  const std::vector<Damage> damages{
      {"no field 'instance' or 'label'", [](PointCloud2& c) { c.fields[0].name = "ring"; }},
      {"fields['label'].datatype: is 7", [](PointCloud2& c) { c.fields[0].datatype = PointField::FLOAT32; }},
      {"fields['label'].datatype: is 0", [](PointCloud2& c) { c.fields[0].datatype = 0; }},
      {"fields['label'].count: is 2", [](PointCloud2& c) { c.fields[0].count = 2; }},
      {"fields['label'].offset: 21", [](PointCloud2& c) { c.fields[0].offset = 21; }},
      {"fields['label'].offset: 4294967295", [](PointCloud2& c) { c.fields[0].offset = 0xFFFFFFFFU; }},
      {"no field 'x'", [](PointCloud2& c) { c.fields[1].name = "q"; }},
      {"row_step", [](PointCloud2& c) { c.row_step = 5; }},
      {"data: has", [](PointCloud2& c) { c.data.pop_back(); }},
      {"width x height", [](PointCloud2& c) { c.width = 0xFFFFFFFFU; }},
      {"is_bigendian", [](PointCloud2& c) { c.is_bigendian = true; }},
  };
  for (const Damage& damage : damages) {
    PointCloud2 cloud = LabelledCloudMaker().make(blob(6), kLabels);
    damage.apply(cloud);
    EXPECT_NE(error_of(cloud).find(damage.expected), std::string::npos)
        << "'" << error_of(cloud) << "' lacks '" << damage.expected << "'";
  }
}

TEST(LabelledCloud, MissingRowStepOfPackedDataIsAccepted) {
  const Points points = blob(6);
  PointCloud2 cloud = LabelledCloudMaker().make(points, kLabels);
  cloud.row_step = 0;
  expect_split(cloud, points);
}

TEST(LabelledCloud, NumbersThatAreNoLabelsAreRefused) {
  std::vector<std::int64_t> labels(257);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels[i] = static_cast<std::int64_t>(i) + 1;
  }
  EXPECT_NE(error_of(LabelledCloudMaker().make(blob(257), labels)).find("more than 256"), std::string::npos);
}

}  // namespace
}  // namespace rigidformer_ros
