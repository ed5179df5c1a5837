// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rigidformer_ros/GetModelInfo.h>
#include <rigidformer_ros/ObjectClouds.h>

#include "rigidformer_ros/node/node_client.hpp"

namespace rigidformer_ros::testing {
namespace {

// A ground at z = 0 would stop the body after a third of the forecast. Without ground it must go on falling.
TEST(NoGround, ObjectsFallPastTheHeightOfTheMissingGround) {
  NodeClient client;
  const auto ready = [] {
    GetModelInfo info;
    return ros::service::call("get_model_info", info) && info.response.ready;
  };
  ASSERT_TRUE(NodeClient::wait_until(ready, 120.0));
  ros::NodeHandle node;
  ros::Publisher publisher = node.advertise<ObjectClouds>("object_clouds", 5);
  ASSERT_TRUE(NodeClient::wait_until([&] { return publisher.getNumSubscribers() > 0; }));
  Flight flight;
  flight.velocity.setZero();
  flight.angular_velocity.setZero();
  const ros::Time start = ros::Time::now();
  ros::Time stamp;
  for (int i = 0; i < 10; ++i) {
    stamp = ros::Time::now();
    ObjectClouds message;
    message.header.stamp = stamp;
    message.ids = {"a"};
    message.clouds = {to_cloud(flight.pose((stamp - start).toSec()).apply(blob()))};
    publisher.publish(message);
    NodeClient::wait_until([] { return false; }, 1.0 / 30.0);
  }
  ASSERT_TRUE(NodeClient::wait_until([&] { return client.last_forecast.header.stamp == stamp; }));
  EXPECT_LT(largest_error(client.last_forecast, "a", flight, start), 0.1);
  EXPECT_LT(client.last_forecast.objects.at(0).poses.back().position.z, -2.0);
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "no_ground_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
