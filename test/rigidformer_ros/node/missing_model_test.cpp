// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rigidformer_ros/GetModelInfo.h>

#include "rigidformer_ros/node/node_client.hpp"

namespace rigidformer_ros::testing {
namespace {

TEST(MissingModel, NodeStaysUpAndNamesTheFile) {
  const auto names_the_file = [] {
    GetModelInfo info;
    return ros::service::call("get_model_info", info) && !info.response.ready &&
           info.response.message.find("/nowhere/none.safetensors") != std::string::npos;
  };
  ASSERT_TRUE(NodeClient::wait_until(names_the_file));
  const Rollout::Response response = NodeClient::call({});
  EXPECT_EQ(response.error_code, Rollout::Response::NOT_READY);
  EXPECT_NE(response.message.find("none.safetensors"), std::string::npos) << response.message;
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "missing_model_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
