// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/rollout_command.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "rigidformer_ros/services/request_error.hpp"

namespace rigidformer_ros {
namespace {

std::vector<std::vector<double>> read(const std::vector<double>& control, int control_dim, int num_steps = 3) {
  PredictRollout::Request request;
  request.control = control;
  rigidformer::ModelInfo model;
  model.control_dim = control_dim;
  return read_control(request, num_steps, model);
}

TEST(RolloutCommand, IsOneForAllStepsOrOnePerStep) {
  using Commands = std::vector<std::vector<double>>;
  EXPECT_EQ(read({}, 0), Commands());
  EXPECT_EQ(read({1.0, 2.0}, 2), (Commands{{1.0, 2.0}}));
  EXPECT_EQ(read({1.0, 2.0, 3.0}, 1), (Commands{{1.0}, {2.0}, {3.0}}));
}

TEST(RolloutCommand, OtherNumbersOfNumbersAreRefused) {
  EXPECT_THROW(read({1.0}, 0), RequestError);
  EXPECT_THROW(read({}, 2), RequestError);
  EXPECT_THROW(read({1.0, 2.0, 3.0, 4.0}, 2), RequestError) << "two commands for three steps";
  EXPECT_THROW(read({std::numeric_limits<double>::infinity()}, 1), RequestError);
}

}  // namespace
}  // namespace rigidformer_ros
