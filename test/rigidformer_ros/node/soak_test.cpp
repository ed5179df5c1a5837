// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rigidformer_ros/GetModelInfo.h>
#include <rosgraph_msgs/Clock.h>
#include <visualization_msgs/MarkerArray.h>

#include <iostream>
#include <map>
#include <string>

#include "rigidformer_ros/node/latencies.hpp"
#include "rigidformer_ros/node/node_client.hpp"
#include "rigidformer_ros/node/node_process.hpp"
#include "rigidformer_ros/node/restless_scene.hpp"

namespace rigidformer_ros::testing {
namespace {

// [s] of simulated time between two frames, as from a camera of 30 Hz.
constexpr double kFramePeriod = 1.0 / 30.0;
// [s] of simulated time until the clock starts anew; chosen by eye.
constexpr double kLoopDuration = 20.0;
// Bytes of a mebibyte.
constexpr double kMiB = 1024.0 * 1024.0;
// Frames between two calls of predict_rollout; chosen by eye.
constexpr int kFramesPerService = 50;

class SoakTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(client.wait_until(
        [] {
          GetModelInfo info;
          return ros::service::call("get_model_info", info) && info.response.ready;
        },
        120.0));
    set_clock(now);
  }

  void set_clock(const ros::Time& time) {
    rosgraph_msgs::Clock message;
    message.clock = time;
    clock.publish(message);
  }

  // Sets the clock back and waits until the node has noticed: it would refuse clouds that reach it before the clock.
  void restart_clock() {
    now = loop_start;
    scene.restart();
    last_usable.clear();
    ++loops;
    set_clock(now);
    EXPECT_TRUE(client.wait_until([] { return NodeClient::call({}).error_code == Rollout::Response::NO_OBJECTS; }));
  }

  // Publishes all clouds of one frame and waits for their forecast. Returns false when none came although it had to.
  bool play_frame(double patience_s = 10.0) {
    now += ros::Duration(kFramePeriod);
    if (now > loop_start + ros::Duration(kLoopDuration)) {
      restart_clock();
    }
    set_clock(now);
    const ros::WallTime published = ros::WallTime::now();
    for (RestlessScene::Cloud& cloud : scene.clouds_at(now)) {
      client.object(cloud.id).publish(cloud.message);
      if (cloud.usable) {
        last_usable[cloud.id] = now;
      }
      ++clouds;
    }
    if (!is_complete()) {
      return true;
    }
    if (!client.wait_until([&] { return client.last_forecast.header.stamp == now; }, patience_s)) {
      return false;
    }
    latencies.add((ros::WallTime::now() - published).toSec());
    return true;
  }

  // Tells whether the node has seen all objects at this instant, so that it must forecast from it.
  bool is_complete() const {
    bool any = false;
    for (const auto& [id, stamp] : last_usable) {
      any = any || stamp == now;
      if (stamp != now && (now - stamp).toSec() < sync_window) {
        return false;
      }
    }
    return any;
  }

  const double sync_window = ros::param::param("/prediction_node/input/sync_window", 0.0);
  NodeClient client;
  ros::NodeHandle node;
  ros::Publisher clock = node.advertise<rosgraph_msgs::Clock>("/clock", 10);
  const ros::Time loop_start = ros::Time(1000.0);
  ros::Time now = loop_start;
  RestlessScene scene = RestlessScene(11);
  std::map<std::string, ros::Time> last_usable;
  Latencies latencies;
  int clouds = 0;
  int loops = 0;
};

TEST_F(SoakTest, P18_MemoryStaysFlatAndEveryFrameIsForecast) {
  const int wanted = ros::param::param("~clouds", 2000);
  const int process = node_pid(ros::names::resolve("prediction_node"));
  int drawn = 0;
  const auto markers = node.subscribe<visualization_msgs::MarkerArray>(
      "markers", 1, [&](const visualization_msgs::MarkerArray::ConstPtr&) { ++drawn; });
  // The first frames may come before the node knows the simulated clock, and their forecasts before this program is
  // connected to the node.
  bool has_begun = false;
  for (int attempt = 0; attempt < 5 && !has_begun; ++attempt) {
    has_begun = play_frame(4.0);
  }
  ASSERT_TRUE(has_begun) << "no forecast to begin with";
  double early_bytes = 0.0;
  int missing = 0;
  for (int frame = 0; clouds < wanted; ++frame) {
    missing += play_frame() ? 0 : 1;
    ASSERT_LT(missing, 3) << "forecasts stopped after " << clouds << " clouds";
    if (frame % kFramesPerService == 0) {
      NodeClient::call({});
    }
    if (early_bytes == 0.0 && clouds >= wanted / 4) {
      early_bytes = resident_bytes(process);
    }
  }
  const double late_bytes = resident_bytes(process);
  std::cout << clouds << " clouds, " << loops << " restarts of the clock, cloud to forecast: " << latencies.describe()
            << "; without forecast: " << missing << "; resident memory " << early_bytes / kMiB
            << " MiB after a quarter, " << late_bytes / kMiB << " MiB at the end" << std::endl;
  EXPECT_EQ(missing, 0);
  EXPECT_GT(drawn, 0);
  EXPECT_LT((late_bytes - early_bytes) / kMiB, ros::param::param("~max_growth", 0.0));
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "soak_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
