// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation_parameters.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace {

using XmlRpc::XmlRpcValue;

/// The message that refuses `value` of parameter `name`; empty = it is accepted.
template <typename Value>
std::string refusal(const std::string& name, const Value& value) {
  XmlRpcValue tree;
  tree[name] = value;
  try {
    read_segmentation_parameters(tree);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SegmentationParameters, P48_ValuesAreReadAndAbsentOnesKeepTheirDefaults) {
  XmlRpcValue tree;
  tree["cluster_tolerance"] = 1;  // YAML writes 1 for 1.0
  tree["max_missed_frames"] = 7;
  const SegmentationParameters read = read_segmentation_parameters(tree);
  EXPECT_EQ(read.options.cluster_tolerance, 1.0);
  EXPECT_EQ(read.max_missed_frames, 7);
  EXPECT_EQ(read.options.max_range, SegmentationOptions().max_range);
  EXPECT_EQ(read_segmentation_parameters(XmlRpcValue()).options.min_cluster_points, 30);
}

TEST(SegmentationParameters, P48_ErrorsNameParameterValueAndWhatIsAccepted) {
  for (const double length : {0.0, -0.02, 1e9}) {
    for (const char* name : {"cluster_tolerance", "plane_distance", "max_match_distance"}) {
      const std::string message = refusal(name, XmlRpcValue(length));
      EXPECT_NE(message.find(std::string("parameter ") + name + ": is "), std::string::npos) << message;
      EXPECT_NE(message.find("must be a number in ["), std::string::npos) << message;
    }
  }
  EXPECT_NE(refusal("cluster_tolerance", XmlRpcValue("2cm")).find("is '2cm'"), std::string::npos);
  EXPECT_NE(refusal("min_cluster_points", XmlRpcValue(0)).find("an integer in [1"), std::string::npos);
  EXPECT_NE(refusal("min_cluster_points", XmlRpcValue(24.0)).find("an integer"), std::string::npos);
  EXPECT_NE(refusal("min_plane_share", XmlRpcValue(1.5)).find("in [0, 1]"), std::string::npos);
}

TEST(SegmentationParameters, P48_UnknownNamesAreErrorsThatListTheKnownOnes) {
  const std::string message = refusal("cluster_tolerence", XmlRpcValue(0.02));
  EXPECT_NE(message.find("cluster_tolerence: unknown"), std::string::npos) << message;
  EXPECT_NE(message.find("cluster_tolerance"), std::string::npos) << message;
}

}  // namespace
