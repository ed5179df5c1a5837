// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/scene/defects.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "rigidformer_ros/node/node_client.hpp"

namespace rigidformer_ros::testing {
namespace {

constexpr int kRounds = 12;            // random scenes, so that each defect comes several times
constexpr double kFramePeriod = 0.05;  // [s] between the two clouds of a scene
constexpr double kApart = 8.0;         // [m] between objects: none reaches another within a forecast

/// The connection to one of two nodes with the same model, in its namespace.
struct Side {
  explicit Side(const std::string& ns) : node(ns) {
    clouds = node.advertise<ObjectClouds>("object_clouds", 10);
    subscriber = node.subscribe<SceneForecast>(
        "forecast", 100, [this](const SceneForecast::ConstPtr& m) { forecasts[m->header.stamp] = *m; });
  }

  bool ready() {
    GetModelInfo info;
    return ros::service::call(node.resolveName("get_model_info"), info) && info.response.ready &&
           clouds.getNumSubscribers() > 0 && subscriber.getNumPublishers() > 0;
  }

  void reset() {
    std_srvs::Trigger service;
    EXPECT_TRUE(ros::service::call(node.resolveName("reset"), service));
  }

  ros::NodeHandle node;
  ros::Publisher clouds;
  ros::Subscriber subscriber;
  std::map<ros::Time, SceneForecast> forecasts;  ///< All forecasts by their t0
};

/// An object of a random scene. Healthy ones fly, defective ones hang still.
struct Member {
  std::string id;
  Flight flight;
  rigidformer::ObjectState state;  ///< Points and material as observed
  bool is_healthy = true;
};

std::vector<Member> random_members(std::mt19937& random) {
  const auto defects = rigidformer::testing::observable_defects();
  const auto num_healthy = 1 + random() % 3, num_defective = 1 + random() % 3;
  std::vector<Member> members(num_healthy + num_defective);
  for (std::size_t i = 0; i < members.size(); ++i) {
    Member& member = members[i];
    member.is_healthy = i < num_healthy;
    member.state.points_reference = blob(40, static_cast<unsigned>(random()));
    member.flight.start.x() = kApart * static_cast<double>(i);
    member.flight.start.z() = 6.0;
    if (!member.is_healthy) {
      defects[random() % defects.size()].apply(member.state);
    }
  }
  std::shuffle(members.begin(), members.end(), random);
  for (std::size_t i = 0; i < members.size(); ++i) {
    members[i].id = "object_" + std::to_string(i);
  }
  return members;
}

PhysicalProperties to_message(const rigidformer::BodyProperties& properties) {
  PhysicalProperties message;
  if (properties.mass_kg) {
    message.known = PhysicalProperties::MASS;
    message.mass = *properties.mass_kg;
  }
  return message;
}

ObjectClouds scene_of(const std::vector<Member>& members, bool with_defective, const ros::Time& stamp, double t) {
  ObjectClouds scene;
  scene.header.frame_id = "world";
  scene.header.stamp = stamp;
  for (const Member& member : members) {
    if (member.is_healthy || with_defective) {
      scene.ids.push_back(member.id);
      scene.clouds.push_back(to_cloud(member.flight.pose(t).apply(member.state.points_reference)));
      scene.properties.push_back(to_message(member.state.properties));
    }
  }
  return scene;
}

TEST(Defects, P36_HealthyObjectsHaveTheForecastsThatTheyHaveWithoutDefectiveOnes) {
  Side whole("/whole"), spoilt("/spoilt");
  ASSERT_TRUE(NodeClient::wait_until([&] { return whole.ready() && spoilt.ready(); }, 120.0));
  std::mt19937 random(11);
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Member> members = random_members(random);
    const ros::Time t0 = ros::Time::now();
    for (const double t : {0.0, kFramePeriod}) {
      const ros::Time stamp = t0 - ros::Duration(kFramePeriod - t);
      whole.clouds.publish(scene_of(members, /*with_defective=*/false, stamp, t));
      spoilt.clouds.publish(scene_of(members, /*with_defective=*/true, stamp, t));
    }
    ASSERT_TRUE(NodeClient::wait_until([&] { return whole.forecasts.count(t0) > 0 && spoilt.forecasts.count(t0) > 0; }))
        << "no forecast of scene " << round;
    const SceneForecast &expected = whole.forecasts[t0], &actual = spoilt.forecasts[t0];
    EXPECT_EQ(actual.objects, expected.objects) << "the same bytes, scene " << round;
    for (const Member& member : members) {
      const auto skipped = std::find(actual.skipped_ids.begin(), actual.skipped_ids.end(), member.id);
      EXPECT_EQ(skipped == actual.skipped_ids.end(), member.is_healthy) << member.id;
    }
    EXPECT_EQ(std::count(actual.skip_reasons.begin(), actual.skip_reasons.end(), ""), 0);
    whole.reset();
    spoilt.reset();
  }
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "defects_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
