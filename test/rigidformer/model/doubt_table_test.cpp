// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/doubt_table.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rigidformer {
namespace {

/// Every cell is another one.
DoubtTable numbered_table() {
  DoubtTable table;
  double number = 0.0;
  for (auto& phases : table.cells) {
    for (auto& cells : phases) {
      for (DoubtCell& cell : cells) {
        number += 0.001;
        cell = {{number, 2.0 * number}, {3.0 * number, 4.0 * number}, 5.0 * number, 6.0 * number};
      }
    }
  }
  return table;
}

TEST(DoubtTable, TextRoundTripLosesNothing) {
  const DoubtTable table = numbered_table();
  const std::string text = to_json(table);
  EXPECT_EQ(to_json(doubt_table_from_json(text)), text);
  const DoubtCell cell = doubt_table_from_json(text).at(Knowledge::kOneSide, Phase::kResting, 0.8);
  EXPECT_NEAR(cell.alone.position_m, 0.045, 1e-12);
  EXPECT_NEAR(cell.rotation_spread_scale, 0.27, 1e-12);
}

TEST(DoubtTable, RefusesEverythingElse) {
  std::string text = to_json(numbered_table());
  EXPECT_THROW(doubt_table_from_json("[]"), std::runtime_error);
  EXPECT_THROW(doubt_table_from_json("{"), std::runtime_error);
  EXPECT_THROW(doubt_table_from_json("[" + text.substr(text.find("],") + 2)), std::runtime_error) << "a row less";
  EXPECT_THROW(doubt_table_from_json(text.substr(0, text.size() - 1) + ",[0,0,0,0,0,0]]"), std::runtime_error);
  text.replace(text.find("0.001"), 5, "-0.01");
  EXPECT_THROW(doubt_table_from_json(text), std::runtime_error);
}

TEST(DoubtTable, IsLinearBetweenItsTimesAndGrowsAfterTheLast) {
  const DoubtTable table = numbered_table();
  const auto position = [&](double time_s) {
    return table.at(Knowledge::kMaterial, Phase::kFree, time_s).alone.position_m;
  };
  EXPECT_DOUBLE_EQ(position(0.0), 0.001);
  EXPECT_DOUBLE_EQ(position(0.05), 0.001);
  EXPECT_DOUBLE_EQ(position(0.15), 0.0025);
  EXPECT_DOUBLE_EQ(position(0.8), 0.005);
  EXPECT_DOUBLE_EQ(position(1.6), 0.010);
  EXPECT_DOUBLE_EQ(table.at(Knowledge::kMaterial, Phase::kFree, 1.6).position_spread_scale, 0.025) << "has no unit";
}

}  // namespace
}  // namespace rigidformer
