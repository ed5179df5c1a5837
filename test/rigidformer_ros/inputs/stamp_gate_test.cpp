// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/stamp_gate.hpp"

#include <gtest/gtest.h>

namespace rigidformer_ros {
namespace {

TEST(StampGate, P06_accepts_the_present_and_names_the_likely_cause_otherwise) {
  const StampGate gate(5.0, 0.5);
  const ros::Time now(1000.0);
  EXPECT_FALSE(gate.objection(ros::Time(999.0), now));
  EXPECT_FALSE(gate.objection(ros::Time(1000.3), now));
  EXPECT_NE(gate.objection(ros::Time(0), now)->find("stamp is 0"), std::string::npos);
  EXPECT_NE(gate.objection(ros::Time(1.7e9), now)->find("wall-clock stamps"), std::string::npos);
  EXPECT_NE(gate.objection(ros::Time(900.0), now)->find("--clock"), std::string::npos);
  EXPECT_NE(gate.objection(now, ros::Time(0))->find("/clock"), std::string::npos);
}

TEST(StampGate, P57_the_cause_fits_and_the_parameter_is_named) {
  const StampGate gate(5.0, 0.5);
  const ros::Time now(1.8e9);
  const auto objection = [&](double stamp_s) { return *gate.objection(ros::Time(stamp_s), now); };
  for (const double stamp_s : {1.8e9 + 7.0, 1.8e9 - 7.0, 320.0}) {
    EXPECT_NE(objection(stamp_s).find("max_stamp_skew is 5 s"), std::string::npos) << objection(stamp_s);
    EXPECT_EQ(objection(stamp_s).find("bag"), std::string::npos) << objection(stamp_s);
  }
  EXPECT_NE(objection(320.0).find("clock of its own"), std::string::npos) << objection(320.0);
  EXPECT_NE(objection(1.7e9).find("--clock"), std::string::npos) << objection(1.7e9);
}

TEST(StampGate, ReportsARestartOnce) {
  StampGate gate(5.0, 0.5);
  EXPECT_FALSE(gate.clock_restarted(ros::Time(100.0)));
  EXPECT_FALSE(gate.clock_restarted(ros::Time(99.9)));
  EXPECT_TRUE(gate.clock_restarted(ros::Time(98.0)));
  EXPECT_FALSE(gate.clock_restarted(ros::Time(98.1)));
}

TEST(StampGate, P07_refuses_leftovers_from_before_a_restart) {
  StampGate gate(5.0, 0.5);
  gate.clock_restarted(ros::Time(100.0));
  EXPECT_FALSE(gate.objection(ros::Time(103.0), ros::Time(100.0)));
  gate.clock_restarted(ros::Time(97.0));
  EXPECT_TRUE(gate.objection(ros::Time(100.02), ros::Time(97.0)));
  EXPECT_FALSE(gate.objection(ros::Time(97.02), ros::Time(97.0)));
}

}  // namespace
}  // namespace rigidformer_ros
