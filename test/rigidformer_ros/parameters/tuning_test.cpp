// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/tuning.hpp"

#include <gtest/gtest.h>
#include <rigidformer_ros/DiagnosticsConfig.h>
#include <rigidformer_ros/DisplayConfig.h>
#include <rigidformer_ros/PredictConfig.h>

#include <stdexcept>
#include <string>

namespace rigidformer_ros {
namespace {

using XmlRpc::XmlRpcValue;

bool accepts(const std::string& group, const std::string& name, const XmlRpcValue& value) {
  XmlRpcValue tree;
  tree[group][name] = value;
  try {
    read_parameters(tree);
  } catch (const std::invalid_argument&) {
    return false;
  }
  return true;
}

// Checks that a value is within the range of dynamic_reconfigure exactly when the YAML file may hold it.
template <class Config>
void expect_same_ranges(const std::string& group) {
  const dynamic_reconfigure::ConfigDescription& ranges = Config::__getDescriptionMessage__();
  for (const auto& parameter : ranges.max.doubles) {
    EXPECT_TRUE(accepts(group, parameter.name, parameter.value)) << parameter.name;
    EXPECT_FALSE(accepts(group, parameter.name, parameter.value * 1.001)) << parameter.name;
  }
  for (const auto& parameter : ranges.min.doubles) {
    EXPECT_TRUE(accepts(group, parameter.name, parameter.value)) << parameter.name;
    EXPECT_FALSE(accepts(group, parameter.name, parameter.value - 1e-6)) << parameter.name;
  }
  for (const auto& parameter : ranges.max.ints) {
    EXPECT_TRUE(accepts(group, parameter.name, parameter.value)) << parameter.name;
    EXPECT_FALSE(accepts(group, parameter.name, parameter.value + 1)) << parameter.name;
  }
  for (const auto& parameter : ranges.min.ints) {
    EXPECT_TRUE(accepts(group, parameter.name, parameter.value)) << parameter.name;
    EXPECT_FALSE(accepts(group, parameter.name, parameter.value - 1)) << parameter.name;
  }
  for (const auto& parameter : ranges.dflt.bools) {
    EXPECT_TRUE(accepts(group, parameter.name, XmlRpcValue(false))) << parameter.name;
  }
  EXPECT_TRUE(ranges.dflt.strs.empty()) << "no file can be named through a service";
}

TEST(Tuning, TakesTheRangesOfTheParameters) {
  expect_same_ranges<PredictConfig>("predict");
  expect_same_ranges<DisplayConfig>("display");
  expect_same_ranges<DiagnosticsConfig>("diagnostics");
}

}  // namespace
}  // namespace rigidformer_ros
