// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "rigidformer_ros/parameters/parameters.hpp"
#include "rigidformer_ros/parameters/tuning_messages.hpp"

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
template <class Parameters>
void expect_same_ranges(const std::string& group) {
  const dynamic_reconfigure::ConfigDescription ranges = describe_tunable<Parameters>();
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
  expect_same_ranges<PredictParameters>("predict");
  expect_same_ranges<DisplayParameters>("display");
  expect_same_ranges<DiagnosticsParameters>("diagnostics");
}

template <class Parameters>
std::vector<std::string> names() {
  const dynamic_reconfigure::ConfigDescription description = describe_tunable<Parameters>();
  std::vector<std::string> names;
  for (const auto& parameter : description.groups.at(0).parameters) {
    names.push_back(parameter.type + " " + parameter.name);
  }
  return names;
}

TEST(Tuning, OffersWhatOnlyTunesTheRunningNode) {
  EXPECT_EQ(names<PredictParameters>(), (std::vector<std::string>{"double rate", "int num_steps"}));
  EXPECT_EQ(names<DisplayParameters>().front(), "bool markers");
  EXPECT_EQ(names<DisplayParameters>().size(), 7U);
  EXPECT_EQ(
      names<DiagnosticsParameters>(),
      (std::vector<std::string>{"double max_input_age", "double max_processing_time", "double max_consecutive_delay",
                                "double trusted_position_error", "double trusted_rotation_error"}));
  EXPECT_TRUE(names<ServiceParameters>().empty());
}

TEST(Tuning, ChangesWhatIsNamedAndClampsIt) {
  DisplayParameters display;
  dynamic_reconfigure::Config change;
  append(change, "ghost_every", 0);
  append(change, "point_size", std::numeric_limits<double>::infinity());
  append(change, "markers", false);
  append(change, "colour", 3.0);
  take_over(change, display);
  EXPECT_EQ(display.ghost_every, 1);
  EXPECT_EQ(display.point_size, 100.0);
  EXPECT_FALSE(display.markers);
  EXPECT_EQ(display.label_size, DisplayParameters().label_size);
  EXPECT_EQ(to_config(display).ints.at(0).value, 1);
}

TEST(Tuning, WhatIsNoNumberChangesNothing) {
  PredictParameters predict;
  dynamic_reconfigure::Config change;
  append(change, "num_steps", 3);
  append(change, "rate", std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(take_over(change, predict), std::invalid_argument);
  EXPECT_EQ(predict.num_steps, PredictParameters().num_steps);
}

}  // namespace
}  // namespace rigidformer_ros
