// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rigidformer_ros/GetModelInfo.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "rigidformer_ros/node/latencies.hpp"
#include "rigidformer_ros/node/node_client.hpp"

namespace rigidformer_ros::testing {
namespace {

// Number of planners; chosen by eye. load.test lets 16 requests wait, so none of them may be refused.
constexpr int kClients = 8;
// [s] between two frames, as from a camera of 30 Hz.
constexpr double kFramePeriod = 1.0 / 30.0;

// A planner that calls the service without a pause until it is told to stop.
struct Planner {
  explicit Planner(const std::atomic<bool>& stop)
      : thread([this, &stop] {
          ros::NodeHandle node;
          ros::ServiceClient service = node.serviceClient<Rollout>("predict_rollout", /*persistent=*/true);
          while (!stop) {
            ask(service);
          }
        }) {}

  void ask(ros::ServiceClient& service) {
    Rollout rollout;
    rollout.request.max_state_age = ros::Duration(30.0);
    const ros::WallTime start = ros::WallTime::now();
    if (!service.call(rollout) || !rollout.response.success) {
      last_error = rollout.response.message;
      ++failures;
      return;
    }
    latencies.add((ros::WallTime::now() - start).toSec());
  }

  Latencies latencies;
  int failures = 0;
  std::string last_error;
  std::thread thread;
};

class LoadTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(client.wait_until(
        [] {
          GetModelInfo info;
          return ros::service::call("get_model_info", info) && info.response.ready;
        },
        120.0));
    for (int i = 0; i < num_objects; ++i) {
      const std::string id = "load_" + std::to_string(i);
      flights[id].start = {3.0 * i, 0.0, 0.0};
      flights[id].gravity = 0.0;
      client.object(id);
    }
  }

  // Publishes clouds of all objects at 30 Hz for `seconds` seconds.
  void stream(double seconds) {
    const Points points = blob(4016);
    const ros::Time start = ros::Time::now();
    for (int frame = 0; frame * kFramePeriod < seconds; ++frame) {
      last_stamp = ros::Time::now();
      for (const auto& [id, flight] : flights) {
        client.object(id).publish(stamped_cloud(flight.pose((last_stamp - start).toSec()).apply(points), last_stamp));
      }
      ++frames;
      const double wait = (frame + 1) * kFramePeriod - (ros::Time::now() - start).toSec();
      client.wait_until([] { return false; }, std::max(wait, 0.0));
    }
  }

  std::size_t num_with_velocity() const {
    const auto& objects = client.last_forecast.objects;
    return static_cast<std::size_t>(std::count_if(objects.begin(), objects.end(), [](const ObjectForecast& object) {
      return object.status != ObjectForecast::ASSUMED_STATIC;
    }));
  }

  // Streams until all objects are in a forecast with a velocity. Planners are refused while that of an object is
  // unknown, and a slow node needs more than a few frames to know them all.
  void stream_until_all_are_forecast() {
    for (int attempt = 0; attempt < 50 && num_with_velocity() < flights.size(); ++attempt) {
      stream(0.3);
    }
    ASSERT_EQ(num_with_velocity(), flights.size());
  }

  const int num_objects = ros::param::param("~objects", 8);
  NodeClient client;
  std::map<std::string, Flight> flights;
  ros::Time last_stamp;
  int frames = 0;
};

TEST_F(LoadTest, P22_NewestFrameIsForecastAndNoPlannerStarves) {
  ASSERT_NO_FATAL_FAILURE(stream_until_all_are_forecast());
  std::atomic<bool> stop{false};
  std::vector<std::unique_ptr<Planner>> planners;
  for (int i = 0; i < kClients; ++i) {
    planners.push_back(std::make_unique<Planner>(stop));
  }
  stream(ros::param::param("~seconds", 3.0));
  EXPECT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == last_stamp; }))
      << "the newest frame was lost: " << (last_stamp - client.last_forecast.header.stamp).toSec() << " s";
  EXPECT_EQ(client.last_forecast.objects.size(), flights.size());
  stop = true;
  Latencies all;
  for (auto& planner : planners) {
    planner->thread.join();
    EXPECT_EQ(planner->failures, 0) << planner->last_error;
    EXPECT_GT(planner->latencies.size(), 0U) << "a planner starved";
    all.add(planner->latencies);
  }
  std::cout << flights.size() << " objects x 4016 points, " << frames << " frames at 30 Hz, " << client.num_forecasts
            << " of them forecast; predict_rollout from " << kClients << " clients: " << all.describe() << std::endl;
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "load_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
