// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rosgraph_msgs/Clock.h>
#include <visualization_msgs/MarkerArray.h>

#include <set>
#include <string>
#include <utility>

#include "rigidformer_ros/node/diagnostics_client.hpp"
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

  // Plays simulated time from `from` [s] on in frames of 1/30 s, with a flight that starts at that time.
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
  DiagnosticsClient diagnostics;
  ros::NodeHandle node;
  ros::Publisher clock = node.advertise<rosgraph_msgs::Clock>("/clock", 10);
  Flight flight;
};

// This has to be the first test, because no clock has been published before it.
TEST_F(SimTimeTest, P10_lives_without_a_clock_and_answers_while_it_stands_still) {
  ASSERT_TRUE(client.wait_until([] { return ros::service::exists("predict_rollout", false); }));
  client.object("a").publish(stamped_cloud(blob(), ros::Time(3.0)));
  ASSERT_TRUE(client.wait_until([&] { return client.call({}).error_code == Response::NO_OBJECTS; }))
      << "no clock: alive, and no object accepted";

  play(100.0, 20);
  ASSERT_TRUE(forecast_reaches(100.0 + 19 / 30.0));
  EXPECT_LT(largest_error(client.last_forecast, "a", flight, ros::Time(100.0)), 0.003);

  client.wait_until([] { return false; }, 1.0);  // The clock stands still, as with a paused bag.
  const Response paused = client.call({});
  EXPECT_TRUE(paused.success) << paused.message;
  EXPECT_NEAR(paused.forecast.header.stamp.toSec(), 100.0 + 19 / 30.0, 1e-6);

  set_clock(102.0);  // The clock goes on, and nothing was seen for longer than max_state_age.
  EXPECT_TRUE(client.wait_until([&] { return client.call({}).error_code == Response::STALE_STATE; }));
}

TEST_F(SimTimeTest, P07_a_looping_bag_starts_over_in_spite_of_a_late_message) {
  std::set<std::pair<std::string, int>> shown;
  ros::NodeHandle markers_node;
  const auto markers = markers_node.subscribe<visualization_msgs::MarkerArray>("markers", 50, [&](const auto& message) {
    for (const visualization_msgs::Marker& marker : message->markers) {
      if (marker.action == visualization_msgs::Marker::ADD) {
        shown.insert({marker.ns, marker.id});
      } else {
        shown.erase({marker.ns, marker.id});
      }
    }
  });
  ASSERT_TRUE(client.wait_until([&] { return markers.getNumPublishers() > 0; }));
  play(200.0, 20);
  ASSERT_TRUE(forecast_reaches(200.0 + 19 / 30.0));
  EXPECT_TRUE(client.wait_until([&] { return !shown.empty(); }));

  set_clock(190.0);
  client.object("a").publish(stamped_cloud(blob(), ros::Time(200.66)));
  ASSERT_TRUE(client.wait_until([&] { return client.call({}).error_code == Response::NO_OBJECTS; }));
  EXPECT_TRUE(client.wait_until([&] { return shown.empty(); })) << "P27: markers go with the time they belong to";
  play(190.0, 20);
  ASSERT_TRUE(forecast_reaches(190.0 + 19 / 30.0));
  EXPECT_LT(largest_error(client.last_forecast, "a", flight, ros::Time(190.0)), 0.003);
  EXPECT_EQ(client.last_forecast.trusted_horizon, 0.0) << "errors of the time before do not count";
}

TEST_F(SimTimeTest, P06_stamps_of_another_clock_are_rejected_with_the_likely_cause) {
  const auto expect_cause = [&](const ros::Time& stamp, const std::string& cause) {
    EXPECT_TRUE(client.wait_until([&] {
      set_clock(300.0);
      client.object("wrong").publish(stamped_cloud(blob(), stamp));
      return diagnostics.value("input", "rejected, bad stamp").find(cause) != std::string::npos;
    })) << diagnostics.value("input", "rejected, bad stamp");
  };
  expect_cause(ros::Time(1.7e9), "wall-clock stamps under simulated time");
  expect_cause(ros::Time(0.0), "stamp is 0");
  expect_cause(ros::Time(360.0), "60.000 s ahead of the clock");
  expect_cause(ros::Time(200.0), "old data");
  EXPECT_NE(client.call({}).error_code, Response::SUCCESS) << "none of them became a state";
  play(300.1, 20);
  EXPECT_TRUE(forecast_reaches(300.1 + 19 / 30.0)) << "good stamps are taken afterwards";
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "sim_time_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
