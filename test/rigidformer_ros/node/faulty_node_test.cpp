// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/PoseArray.h>
#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <visualization_msgs/MarkerArray.h>

#include <atomic>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "rigidformer_ros/node/diagnostics_client.hpp"
#include "rigidformer_ros/node/node_client.hpp"
#include "rigidformer_ros/node/rollout_requests.hpp"

namespace rigidformer_ros::testing {
namespace {

Rollout::Request request_about(const std::string& id, std::uint32_t num_steps = 8) {
  Rollout::Request request;
  request.scene = scene_at(0.0, high_flight());
  request.scene.ids = {id};
  request.num_steps = num_steps;
  return request;
}

/// Clients that all call the service, each one request after another, until they are stopped.
class Storm {
 public:
  Storm(int num_clients, const Rollout::Request& request) {
    for (int i = 0; i < num_clients; ++i) {
      threads_.emplace_back([this, request] {
        while (!stopping_) {
          const std::int32_t code = NodeClient::call(request).error_code;
          std::unique_lock<std::mutex> lock(mutex_);
          ++codes_[code];
          lock.unlock();
          ros::WallDuration(0.005).sleep();
        }
      });
    }
  }
  ~Storm() { stop(); }

  int count(std::int32_t code) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return codes_[code];
  }

  /// Stops the clients and gives the number of their answers by error code.
  std::map<std::int32_t, int> stop() {
    stopping_ = true;
    for (std::thread& thread : threads_) {
      thread.join();
    }
    threads_.clear();
    return codes_;
  }

 private:
  std::atomic<bool> stopping_{false};
  std::mutex mutex_;
  std::map<std::int32_t, int> codes_;
  std::vector<std::thread> threads_;
};

class FaultyNodeTest : public ::testing::Test {
 protected:
  void SetUp() override { client.start_afresh(); }

  NodeClient client;
  DiagnosticsClient diagnostics;
};

TEST_F(FaultyNodeTest, P15_a_throwing_model_costs_one_forecast_and_is_reported) {
  const Response failed = client.call(request_about("throws"));
  EXPECT_EQ(failed.error_code, Response::INTERNAL);
  EXPECT_NE(failed.message.find("tensor trouble"), std::string::npos) << failed.message;
  EXPECT_TRUE(client.call(request_about("good")).success) << "the next request is answered";

  bool reported = false;
  for (int i = 0; i < 20 && !reported; ++i) {
    client.stream({{"throws", high_flight()}}, 6);
    reported = diagnostics.level("model") == diagnostic_msgs::DiagnosticStatus::ERROR;
  }
  EXPECT_TRUE(reported);
  EXPECT_NE(diagnostics.message("model").find("tensor trouble"), std::string::npos) << diagnostics.message("model");
  EXPECT_GT(diagnostics.number("model", "failed forecasts"), 0);
  EXPECT_EQ(client.num_forecasts, 0);

  client.reset();
  client.stream({{"good", high_flight()}}, 12);
  EXPECT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == client.last_stamp; }));
  EXPECT_TRUE(client.wait_until([&] { return diagnostics.level("model") == diagnostic_msgs::DiagnosticStatus::OK; }));
}

bool is_finite(const geometry_msgs::Point& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

TEST_F(FaultyNodeTest, P16_what_is_not_finite_is_never_published) {
  ros::NodeHandle node;
  int published = 0;
  int not_finite = 0;
  const auto check = [&](const geometry_msgs::Point& p) {
    ++published;
    not_finite += is_finite(p) ? 0 : 1;
  };
  const auto poses = node.subscribe<geometry_msgs::PoseArray>("predicted_poses", 10, [&](const auto& message) {
    for (const auto& pose : message->poses) {
      check(pose.position);
    }
  });
  const auto path = node.subscribe<nav_msgs::Path>("paths/nan", 10, [&](const auto& message) {
    for (const auto& pose : message->poses) {
      check(pose.pose.position);
    }
  });
  const auto markers = node.subscribe<visualization_msgs::MarkerArray>("markers", 10, [&](const auto& message) {
    for (const auto& marker : message->markers) {
      check(marker.pose.position);
      for (const auto& point : marker.points) {
        check(point);
      }
    }
  });
  const auto cloud = node.subscribe<sensor_msgs::PointCloud2>("forecast_cloud", 10, [&](const auto& message) {
    not_finite += read_points(*message, 1000000).allFinite() ? 0 : 1;
  });
  client.stream({{"nan", high_flight()}, {"good", without_spin(high_flight(3.0))}}, 18);
  ASSERT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == client.last_stamp; }));
  ASSERT_EQ(client.last_forecast.objects.size(), 2U);
  const ObjectForecast& good = client.last_forecast.objects[0];
  const ObjectForecast& bad = client.last_forecast.objects[1];
  EXPECT_EQ(bad.status, ObjectForecast::DIVERGED);
  EXPECT_EQ(bad.poses.size(), client.last_forecast.times.size());
  for (const auto& pose : bad.poses) {
    check(pose.position);
  }
  EXPECT_EQ(good.status, ObjectForecast::OK);
  EXPECT_LT(largest_error(client.last_forecast, "good", without_spin(high_flight(3.0)), client.flight_start), 0.003);
  EXPECT_GT(published, 100);
  EXPECT_EQ(not_finite, 0);

  const Response response = client.call(request_about("nan"));
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.error_code, Response::DIVERGED);
  for (const auto& pose : response.forecast.objects.at(0).poses) {
    EXPECT_TRUE(is_finite(pose.position));
  }
}

TEST_F(FaultyNodeTest, P22_clouds_and_forecasts_flow_through_a_storm_of_requests) {
  client.stream({{"good", high_flight()}}, 3);
  ASSERT_TRUE(client.wait_until([&] { return diagnostics.number("input", "clouds received") >= 3; }));
  const int lost_before = diagnostics.number("input", "clouds overwritten in a queue");
  // Number of frames sent; chosen by eye. At 30 Hz they take 1.5 s.
  constexpr int kFrames = 45;
  Storm storm(8, request_about("slow", 16));
  ASSERT_TRUE(client.wait_until([&] { return storm.count(Response::BUSY) > 0; }));
  client.stream({{"good", high_flight()}}, kFrames);
  EXPECT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == client.last_stamp; }))
      << "the newest frame is forecast while the service is busy";
  const auto codes = storm.stop();
  EXPECT_TRUE(client.wait_until([&] { return diagnostics.number("input", "clouds received") >= 3 + kFrames; }))
      << "every frame reached the node";
  EXPECT_EQ(diagnostics.number("input", "clouds overwritten in a queue"), lost_before);
  for (const auto& [code, count] : codes) {
    EXPECT_TRUE(code == Response::SUCCESS || code == Response::BUSY) << code << ": " << count;
  }
}

TEST_F(FaultyNodeTest, P23_more_clients_than_may_wait_are_turned_away_and_the_rest_is_answered) {
  Storm storm(8, request_about("slow"));
  EXPECT_TRUE(client.wait_until([&] { return storm.count(Response::BUSY) > 0 && storm.count(Response::SUCCESS) > 3; }));
  GetModelInfo info;
  EXPECT_TRUE(ros::service::call("get_model_info", info)) << "other services do not wait for rollouts";
  storm.stop();
  const Response calm = client.call(request_about("slow"));
  EXPECT_TRUE(calm.success) << calm.message;
}

TEST_F(FaultyNodeTest, P23_a_huge_request_ends_at_its_wall_time_with_what_is_done) {
  Rollout::Request request = request_about("slow", 500);
  request.max_wall_time = ros::Duration(0.3);
  const Response response = client.call(request);
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.error_code, Response::TIMED_OUT) << response.message;
  EXPECT_GT(response.steps_done, 0U);
  EXPECT_LT(response.steps_done, 500U);
  EXPECT_EQ(response.forecast.times.size(), response.steps_done + 1U);
}

TEST_F(FaultyNodeTest, P23_waiting_for_others_counts_towards_the_wall_time) {
  Rollout::Request longer = request_about("slow", 500);
  longer.max_wall_time = ros::Duration(1.0);
  Storm storm(1, longer);
  Rollout::Request impatient = request_about("slow", 500);
  impatient.max_wall_time = ros::Duration(0.05);
  EXPECT_TRUE(client.wait_until([&] {
    const Response response = client.call(impatient);
    return response.error_code == Response::TIMED_OUT && response.message.find("other requests") != std::string::npos;
  }));
}

// The long rollout takes 2.5 s at least: it has 50 jobs of 50 ms.
TEST_F(FaultyNodeTest, P23_a_short_request_is_answered_while_a_long_one_is_under_way) {
  for (const char* about : {"slow", "good"}) {
    std::atomic<bool> long_one_is_answered{false};
    std::thread planner([&] {
      EXPECT_EQ(client.call(request_about("slow", 400)).steps_done, 400U);
      long_one_is_answered = true;
    });
    ros::WallDuration(0.3).sleep();
    const Response response = client.call(request_about(about, 2));
    EXPECT_TRUE(response.success) << response.message;
    EXPECT_EQ(response.steps_done, 2U);
    EXPECT_FALSE(long_one_is_answered) << "the short request about '" << about << "' waited for the long one";
    planner.join();
  }
}

// The forecast is still in progress when it is reported, because it needs three calls of a second each.
TEST_F(FaultyNodeTest, AForecastThatHangsIsReportedWhileItHangs) {
  ASSERT_TRUE(client.wait_until([&] { return diagnostics.level("timing") == diagnostic_msgs::DiagnosticStatus::OK; }));
  client.stream({{"hangs", high_flight()}}, 3);
  EXPECT_TRUE(
      client.wait_until([&] { return diagnostics.level("timing") == diagnostic_msgs::DiagnosticStatus::WARN; }));
  EXPECT_TRUE(
      client.wait_until([&] { return diagnostics.level("timing") == diagnostic_msgs::DiagnosticStatus::ERROR; }));
  EXPECT_EQ(client.num_forecasts, 0);
  EXPECT_NE(diagnostics.message("timing").find("more than 0.300 s"), std::string::npos);
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "faulty_node_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
