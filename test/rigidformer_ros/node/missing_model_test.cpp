// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rigidformer_ros/GetModelInfo.h>

#include <string>

#include "rigidformer_ros/node/node_client.hpp"

namespace rigidformer_ros::testing {
namespace {

// Expects that the node in the namespace `ns` is up but not ready, and that its services say so in a text that contains
// `reason`.
void expect_not_ready(const std::string& ns, const std::string& reason) {
  const auto names_the_reason = [&] {
    GetModelInfo info;
    return ros::service::call(ns + "/get_model_info", info) && !info.response.ready &&
           info.response.message.find(reason) != std::string::npos;
  };
  ASSERT_TRUE(NodeClient::wait_until(names_the_reason, 60.0));
  Rollout rollout;
  ASSERT_TRUE(ros::service::call(ns + "/predict_rollout", rollout));
  EXPECT_FALSE(rollout.response.success);
  EXPECT_EQ(rollout.response.error_code, Rollout::Response::NOT_READY);
  EXPECT_NE(rollout.response.message.find(reason), std::string::npos) << rollout.response.message;
}

TEST(MissingModel, P20_the_node_stays_up_and_names_the_file) {
  expect_not_ready("/missing_file", "/nowhere/none.safetensors");
}

TEST(MissingModel, P21_the_node_stays_up_and_names_the_device) { expect_not_ready("/missing_device", "cuda:99"); }

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "missing_model_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
