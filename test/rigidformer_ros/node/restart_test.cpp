// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <signal.h>

#include "rigidformer_ros/node/node_client.hpp"
#include "rigidformer_ros/node/node_process.hpp"
#include "rigidformer_ros/node/rollout_requests.hpp"

namespace rigidformer_ros::testing {
namespace {

// Full name of the node in restart.test.
constexpr char kNode[] = "/prediction_node";

TEST(Restart, P30_a_killed_node_comes_back_without_stale_forecasts) {
  NodeClient client;
  client.start_afresh();
  client.stream({{"a", without_spin(high_flight())}}, 12);
  ASSERT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == client.last_stamp; }));

  const int pid = node_pid(kNode);
  ASSERT_GT(pid, 0);
  ASSERT_EQ(kill(pid, SIGKILL), 0);
  ASSERT_TRUE(client.wait_until([&] {
    const int new_pid = node_pid(kNode);
    return new_pid > 0 && new_pid != pid;
  }));
  client.num_forecasts = 0;
  ASSERT_TRUE(client.wait_until([] { return ros::service::exists("predict_rollout", false); }));
  ASSERT_TRUE(client.wait_until([&] { return client.call({}).error_code == Response::NO_OBJECTS; }));
  NodeClient late_subscriber;
  client.wait_until([] { return false; }, 0.3);
  EXPECT_EQ(client.num_forecasts + late_subscriber.num_forecasts, 0) << "nothing is known yet: nothing is published";

  client.stream({{"a", without_spin(high_flight())}}, 12);
  ASSERT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == client.last_stamp; }));
  EXPECT_EQ(client.last_forecast.objects.at(0).status, ObjectForecast::OK);
  EXPECT_LT(largest_error(client.last_forecast, "a", without_spin(high_flight()), client.flight_start), 0.003);
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "restart_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
