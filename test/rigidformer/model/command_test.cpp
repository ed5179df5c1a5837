// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/command.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/data/example_archive.hpp"

namespace rigidformer {
namespace {

RolloutOptions commanded(std::vector<std::vector<double>> control) {
  RolloutOptions rollout;
  rollout.num_steps = 3;
  rollout.control = std::move(control);
  return rollout;
}

TEST(Command, IsOneForAllStepsOrOnePerStepAndTheLastGoesOn) {
  EXPECT_FALSE(command_of_step(commanded({}), 0).defined());
  EXPECT_EQ(command_of_step(commanded({{1.0, 2.0}}), 2)[0][1].item<float>(), 2.0F);
  const RolloutOptions per_step = commanded({{1.0}, {2.0}, {3.0}});
  EXPECT_EQ(command_of_step(per_step, 1)[0][0].item<float>(), 2.0F);
  EXPECT_EQ(command_of_step(per_step, 7)[0][0].item<float>(), 3.0F);
}

TEST(Command, IsRefusedWithTheNumbersAtFault) {
  EXPECT_NO_THROW(check_commands(commanded({}), 0));
  EXPECT_NO_THROW(check_commands(commanded({{1.0, 2.0}}), 2));
  const auto error = [](const RolloutOptions& rollout, int dim) {
    return error_of([&] { check_commands(rollout, dim); });
  };
  EXPECT_NE(error(commanded({}), 2).find("wants a command of 2"), std::string::npos);
  EXPECT_NE(error(commanded({{1.0}}), 0).find("wants 0"), std::string::npos);
  EXPECT_NE(error(commanded({{1.0}, {2.0}}), 1).find("each of the 3 steps"), std::string::npos);
  EXPECT_NE(error(commanded({{std::nan("")}}), 1).find("finite"), std::string::npos);
}

}  // namespace
}  // namespace rigidformer
