// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <rigidformer_ros/GetModelInfo.h>
#include <rigidformer_ros/PredictRollout.h>
#include <rigidformer_ros/SceneForecast.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/messages/conversions.hpp"
#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros::testing {

using Rollout = PredictRollout;

inline sensor_msgs::PointCloud2 stamped_cloud(const Points& points, const ros::Time& stamp,
                                              const std::string& frame = "world") {
  sensor_msgs::PointCloud2 cloud = to_cloud(points);
  cloud.header.stamp = stamp;
  cloud.header.frame_id = frame;
  return cloud;
}

/// Plays the perception pipeline and the planner for a running node.
class NodeClient {
 public:
  NodeClient() {
    forecasts_ = node_.subscribe<SceneForecast>("forecast", 10, [this](const SceneForecast::ConstPtr& message) {
      ++num_forecasts;
      last_forecast = *message;
    });
  }

  /// The publisher of an object's clouds. The function returns when the node listens to it.
  ros::Publisher& object(const std::string& id) {
    auto [entry, is_new] = objects_.try_emplace(id);
    if (is_new) {
      entry->second = node_.advertise<sensor_msgs::PointCloud2>("/objects/" + id + "/points", 10);
    }
    EXPECT_TRUE(wait_until([&] { return entry->second.getNumSubscribers() > 0; })) << "nobody listens to " << id;
    return entry->second;
  }

  /// Handles callbacks until the condition holds, at most for `seconds` of wall time.
  static bool wait_until(const std::function<bool()>& condition, double seconds = 20.0) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
    while (ros::ok() && ros::WallTime::now() < end) {
      ros::spinOnce();
      if (condition()) {
        return true;
      }
      ros::WallDuration(0.005).sleep();
    }
    return condition();
  }

  static Rollout::Response call(const Rollout::Request& request) {
    Rollout service;
    service.request = request;
    // The connection is persistent: roscpp closes other connections behind the answer, and its client then sometimes
    // loses the answer.
    ros::ServiceClient connection = ros::NodeHandle().serviceClient<Rollout>("predict_rollout", /*persistent=*/true);
    EXPECT_TRUE(connection.call(service)) << "the handler must always return true";
    return service.response;
  }

  /// Publishes the flights at 30 Hz, `frames` times.
  void stream(const std::map<std::string, Flight>& flights, int frames) {
    for (const auto& [id, flight] : flights) {
      object(id);
    }
    flight_start = ros::Time::now();
    for (int i = 0; i < frames; ++i) {
      last_stamp = ros::Time::now();
      for (const auto& [id, flight] : flights) {
        const Points points = flight.pose((last_stamp - flight_start).toSec()).apply(blob());
        object(id).publish(stamped_cloud(points, last_stamp));
      }
      wait_until([] { return false; }, 1.0 / 30.0);
    }
  }

  /// Waits until the model is loaded, then makes the node forget what it saw before.
  void start_afresh() {
    const auto is_ready = [] {
      GetModelInfo info;
      return ros::service::call("get_model_info", info) && info.response.ready;
    };
    ASSERT_TRUE(wait_until(is_ready, 120.0));
    reset();
  }

  void reset() {
    std_srvs::Trigger service;
    ASSERT_TRUE(ros::service::waitForService("reset", ros::Duration(-1)));
    ASSERT_TRUE(ros::service::call("reset", service));
    EXPECT_TRUE(service.response.success);
    wait_until([] { return false; }, 0.2);  // Forecasts of the old state may still be on their way.
    num_forecasts = 0;
    last_forecast = SceneForecast();
  }

  int num_forecasts = 0;
  SceneForecast last_forecast;
  ros::Time flight_start;  ///< When the newest stream began, which is time 0 of its flights
  ros::Time last_stamp;    ///< Stamp of the last clouds of the newest stream

 private:
  ros::NodeHandle node_;
  ros::Subscriber forecasts_;
  std::map<std::string, ros::Publisher> objects_;
};

/// The largest distance [m] of any predicted point from the place to which the flight really takes it. The flight's
/// time 0 is `flight_start`.
inline double largest_error(const SceneForecast& forecast, const std::string& id, const Flight& flight,
                            const ros::Time& flight_start) {
  for (const ObjectForecast& object : forecast.objects) {
    if (object.id != id) {
      continue;
    }
    const double t0 = (forecast.header.stamp - flight_start).toSec();
    const RigidTransform T_reference_flight = to_transform(object.poses.at(0)).inverse() * flight.pose(t0);
    double error = 0.0;
    for (std::size_t k = 0; k < forecast.times.size(); ++k) {
      const Points predicted = (to_transform(object.poses.at(k)) * T_reference_flight).apply(blob());
      const Points truth = flight.pose(t0 + forecast.times[k]).apply(blob());
      error = std::max(error, static_cast<double>((predicted - truth).rowwise().norm().maxCoeff()));
    }
    return error;
  }
  ADD_FAILURE() << "no forecast of '" << id << "'";
  return -1.0;
}

/// How far [m] a body that turned by `angle` [rad] has drifted in a forecast which took a point one metre from the
/// centre of mass for the centre. Such a forecast moves that point along a tangent, while it really moves on a circle.
inline double drift_of_wrong_centre(double angle) { return std::hypot(1.0 - std::cos(angle), angle - std::sin(angle)); }

}  // namespace rigidformer_ros::testing
