// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "rigidformer_ros/node/node_client.hpp"
#include "rigidformer_ros/node/node_process.hpp"
#include "rigidformer_ros/node/rollout_requests.hpp"

namespace rigidformer_ros::testing {
namespace {

/// The connection to one of the two, the node or the nodelet, in its namespace.
struct Side {
  explicit Side(const std::string& ns) : node(ns) {
    clouds = node.advertise<sensor_msgs::PointCloud2>("objects/a/points", 10);
    subscriber = node.subscribe<SceneForecast>(
        "forecast", 100, [this](const SceneForecast::ConstPtr& m) { forecasts[m->header.stamp] = *m; });
  }

  bool ready() {
    GetModelInfo info;
    return ros::service::call(node.resolveName("get_model_info"), info) && info.response.ready &&
           clouds.getNumSubscribers() > 0 && subscriber.getNumPublishers() > 0;
  }

  ros::NodeHandle node;
  ros::Publisher clouds;
  ros::Subscriber subscriber;
  std::map<ros::Time, SceneForecast> forecasts;  ///< All forecasts by their t0
};

// The names of the node's topics without its namespace, so that those of two namespaces can be compared.
std::set<std::string> relative_topics(const std::string& ns, const std::string& node) {
  std::set<std::string> topics;
  for (const std::string& topic : topics_published_by(node)) {
    if (topic.compare(0, ns.size() + 1, ns + "/") == 0) {
      topics.insert(topic.substr(ns.size() + 1));
    }
  }
  return topics;
}

TEST(Nodelet, GivesTheForecastsOfTheNode) {
  Side as_node("/as_node");
  Side as_nodelet("/as_nodelet");
  ASSERT_TRUE(NodeClient::wait_until([&] { return as_node.ready() && as_nodelet.ready(); }, 120.0));
  const auto publish_both = [&](const ros::Time& stamp, double t) {
    const sensor_msgs::PointCloud2 cloud = stamped_cloud(high_flight().pose(t).apply(blob()), stamp);
    as_node.clouds.publish(cloud);
    as_nodelet.clouds.publish(cloud);
  };
  for (int flight = 0; flight < 3; ++flight) {
    const ros::Time t0 = ros::Time::now();
    publish_both(t0 - ros::Duration(0.05), 0.0);
    publish_both(t0, 0.05);
    ASSERT_TRUE(NodeClient::wait_until([&] {
      return as_node.forecasts.count(t0) > 0 && as_nodelet.forecasts.count(t0) > 0;
    })) << "both forecast the newest cloud";
    EXPECT_EQ(as_node.forecasts[t0].objects.at(0).status, ObjectForecast::OK);
    EXPECT_EQ(as_nodelet.forecasts[t0].objects, as_node.forecasts[t0].objects);
    EXPECT_EQ(as_nodelet.forecasts[t0].times, as_node.forecasts[t0].times);
    EXPECT_EQ(as_nodelet.forecasts[t0].model_id, as_node.forecasts[t0].model_id);
  }
  std::set<std::string> topics = relative_topics("/as_node", "/as_node/prediction_node");
  for (const char* topic : {"forecast", "markers", "forecast_error", "predicted_poses", "paths/a"}) {
    EXPECT_EQ(topics.count(topic), 1U) << topic;
  }
  // The master counts the topics of a nodelet as those of its manager, because they share a process.
  const std::set<std::string> of_manager = relative_topics("/as_nodelet", "/as_nodelet/prediction_manager");
  for (const std::string& topic : topics) {
    EXPECT_EQ(of_manager.count(topic), 1U) << topic;
  }
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
