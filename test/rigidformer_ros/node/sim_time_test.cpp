// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rosgraph_msgs/Clock.h>

#include "rigidformer_ros/node/node_client.hpp"

namespace rigidformer_ros::testing {
namespace {

using Response = Rollout::Response;

class SimTimeTest : public ::testing::Test {
 protected:
  void set_clock(double seconds) {
    rosgraph_msgs::Clock message;
    message.clock = ros::Time(seconds);
    clock.publish(message);
    client.wait_until([] { return false; }, 0.02);
  }

  // Simulated time from `from` on at 30 Hz, with a flight that starts then.
  void play(double from, int frames) {
    for (int i = 0; i < frames; ++i) {
      const double t = i / 30.0;
      set_clock(from + t);
      client.object("a").publish(stamped_cloud(flight.pose(t).apply(blob()), ros::Time(from + t)));
    }
  }

  bool forecast_reaches(double seconds) {
    return client.wait_until([&] { return std::abs(client.last_forecast.header.stamp.toSec() - seconds) < 1e-6; });
  }

  NodeClient client;
  ros::NodeHandle node;
  ros::Publisher clock = node.advertise<rosgraph_msgs::Clock>("/clock", 10);
  Flight flight;
};

TEST_F(SimTimeTest, StartsWithoutClockSurvivesPausesAndLoops) {
  ASSERT_TRUE(client.wait_until([] { return ros::service::exists("predict_rollout", false); }));
  client.object("a").publish(stamped_cloud(blob(), ros::Time(3.0)));
  ASSERT_TRUE(client.wait_until([&] { return client.call({}).error_code == Response::NO_OBJECTS; }))
      << "no clock: alive, and no object accepted";

  play(100.0, 20);
  ASSERT_TRUE(forecast_reaches(100.0 + 19 / 30.0));
  EXPECT_LT(largest_error(client.last_forecast, "a", flight, ros::Time(100.0)), 0.003);

  client.wait_until([] { return false; }, 1.0);  // a paused bag: the clock stands still
  const Response paused = client.call({});
  EXPECT_TRUE(paused.success) << paused.message;
  EXPECT_NEAR(paused.forecast.header.stamp.toSec(), 100.0 + 19 / 30.0, 1e-6);

  set_clock(90.0);  // the bag loops, and one message from before is late
  client.object("a").publish(stamped_cloud(blob(), ros::Time(100.66)));
  ASSERT_TRUE(client.wait_until([&] { return client.call({}).error_code == Response::NO_OBJECTS; }));
  play(90.0, 20);
  ASSERT_TRUE(forecast_reaches(90.0 + 19 / 30.0));
  EXPECT_LT(largest_error(client.last_forecast, "a", flight, ros::Time(90.0)), 0.003);

  set_clock(92.0);  // nothing seen for more than max_state_age
  EXPECT_TRUE(client.wait_until([&] { return client.call({}).error_code == Response::STALE_STATE; }));
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "sim_time_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
