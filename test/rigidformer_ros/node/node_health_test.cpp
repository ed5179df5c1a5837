// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <rigidformer_ros/ForecastError.h>
#include <signal.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <visualization_msgs/MarkerArray.h>

#include <limits>

#include "rigidformer_ros/node/diagnostics_client.hpp"
#include "rigidformer_ros/node/node_client.hpp"
#include "rigidformer_ros/node/node_process.hpp"
#include "rigidformer_ros/node/rollout_requests.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros::testing {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using visualization_msgs::Marker;

// Full name of the node in node_health.test.
constexpr char kNode[] = "/prediction_node";

geometry_msgs::TransformStamped camera_at(const std::string& frame, const RigidTransform& T_world_camera) {
  geometry_msgs::TransformStamped transform;
  const geometry_msgs::Pose pose = to_pose(T_world_camera);
  transform.header.frame_id = "world";
  transform.header.stamp = ros::Time::now();
  transform.child_frame_id = frame;
  transform.transform.translation.x = pose.position.x;
  transform.transform.translation.y = pose.position.y;
  transform.transform.translation.z = pose.position.z;
  transform.transform.rotation = pose.orientation;
  return transform;
}

class NodeHealthTest : public ::testing::Test {
 protected:
  void SetUp() override { client.start_afresh(); }

  bool forecast_reaches_the_last_cloud() {
    return client.wait_until([&] { return client.last_forecast.header.stamp == client.last_stamp; });
  }

  static dynamic_reconfigure::Config reconfigure(const std::string& group, const dynamic_reconfigure::Config& change) {
    dynamic_reconfigure::Reconfigure service;
    service.request.config = change;
    EXPECT_TRUE(ros::service::call(std::string(kNode) + "/" + group + "/set_parameters", service));
    return service.response.config;
  }

  NodeClient client;
  DiagnosticsClient diagnostics;
  ros::NodeHandle node;
};

TEST_F(NodeHealthTest, DiagnosticsTellModelInputTimingAndWhatWasRejected) {
  client.object("a").publish(sensor_msgs::PointCloud2());
  client.stream({{"a", high_flight()}}, 18);
  ASSERT_TRUE(forecast_reaches_the_last_cloud());
  EXPECT_TRUE(client.wait_until([&] { return diagnostics.number("input", "clouds received") >= 19; }));
  EXPECT_EQ(diagnostics.level("input"), DiagnosticStatus::OK);
  EXPECT_EQ(diagnostics.level("model"), DiagnosticStatus::OK);
  EXPECT_EQ(diagnostics.value("model", "state"), "ready");
  EXPECT_EQ(diagnostics.value("model", "device"), "cpu");
  EXPECT_EQ(diagnostics.value("model", "sha256"), "0123456789abcdef");
  EXPECT_EQ(diagnostics.number("input", "objects"), 1);
  EXPECT_GE(diagnostics.number("input", "rejected, bad stamp"), 1);
  EXPECT_NE(diagnostics.value("input", "rejected, bad stamp").find("stamp is 0"), std::string::npos);
  EXPECT_FALSE(diagnostics.value("timing", "inference [ms]").empty());
  EXPECT_TRUE(client.wait_until([&] { return diagnostics.level("input") == DiagnosticStatus::WARN; }))
      << "no cloud for longer than max_input_age";
}

TEST_F(NodeHealthTest, P05_a_missing_transform_is_named_and_its_arrival_is_enough) {
  ros::Publisher& camera = client.object("seen_by_camera");
  const auto send = [&] { camera.publish(stamped_cloud(blob(), ros::Time::now(), "late_camera")); };
  EXPECT_TRUE(client.wait_until([&] {
    send();
    return diagnostics.level("tf") == DiagnosticStatus::WARN;
  }));
  const std::string text = diagnostics.message("tf");
  EXPECT_NE(text.find("late_camera"), std::string::npos) << text;
  EXPECT_NE(text.find("world"), std::string::npos) << text;
  EXPECT_EQ(client.call({}).error_code, Response::NO_OBJECTS) << "never taken for the identity";
  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(camera_at("late_camera", {Eigen::Quaterniond::Identity(), {0.0, 0.0, 5.0}}));
  EXPECT_TRUE(client.wait_until([&] {
    send();
    return client.call({}).success;
  }));
  EXPECT_TRUE(client.wait_until([&] { return diagnostics.level("tf") == DiagnosticStatus::OK; }));
}

// The model lets everything fall, but the object slides. The error of step k is therefore exactly k steps of free fall.
TEST_F(NodeHealthTest, ForecastsAreComparedWithWhatWasThenObserved) {
  ForecastError error;
  const auto errors = node.subscribe<ForecastError>("forecast_error", 10, [&](const auto& m) { error = *m; });
  client.stream({{"a", sliding()}}, 90);
  ASSERT_TRUE(client.wait_until([&] { return error.horizons.size() == 12U && error.num_samples[11] >= 10; }));
  EXPECT_EQ(error.header.frame_id, "world");
  double expected_trust = 0.0;
  for (int k = 1; k <= 12; ++k) {
    const double fall = 10.0 / (24.0 * 24.0) * k * (k + 1) / 2.0;
    EXPECT_NEAR(error.horizons[k - 1], k / 24.0, 1e-9);
    EXPECT_NEAR(error.position_rmse[k - 1], fall, 0.01 * fall + 1e-3) << "step " << k;
    EXPECT_LT(error.rotation_rmse[k - 1], 1e-3);
    expected_trust = fall <= 0.1 ? k / 24.0 : expected_trust;
  }
  EXPECT_NEAR(error.trusted_horizon, expected_trust, 1e-9);
  EXPECT_NEAR(client.last_forecast.trusted_horizon, expected_trust, 1e-9);
  Rollout::Request r;
  r.max_state_age = ros::Duration(30.0);
  EXPECT_NEAR(client.call(r).forecast.trusted_horizon, expected_trust, 1e-9);
  EXPECT_TRUE(client.wait_until([&] {
    return diagnostics.message("forecast quality").find("trusted up to 0.083") != std::string::npos;
  })) << diagnostics.message("forecast quality");
  client.reset();
  client.stream({{"a", sliding()}}, 6);
  ASSERT_TRUE(forecast_reaches_the_last_cloud());
  EXPECT_EQ(client.last_forecast.trusted_horizon, 0.0) << "a reset forgets the errors";
}

TEST_F(NodeHealthTest, FreeFallIsTrustedOverTheWholeHorizon) {
  client.stream({{"a", without_spin(high_flight())}}, 75);
  ASSERT_TRUE(forecast_reaches_the_last_cloud());
  EXPECT_TRUE(client.wait_until([&] {
    return diagnostics.message("forecast quality").find("trusted up to 0.500") != std::string::npos;
  })) << diagnostics.message("forecast quality");
}

TEST_F(NodeHealthTest, PathsHaveAStampPerPoseAndEndWithTheirObjects) {
  nav_msgs::Path path;
  const auto paths = node.subscribe<nav_msgs::Path>("paths/red_cup", 10, [&](const auto& m) { path = *m; });
  client.stream({{"red_cup", high_flight()}}, 18);
  ASSERT_TRUE(client.wait_until([&] { return path.poses.size() == 13U; }));
  EXPECT_EQ(path.header.frame_id, "world");
  for (int k = 0; k <= 12; ++k) {
    EXPECT_NEAR((path.poses[k].header.stamp - path.header.stamp).toSec(), k / 24.0, 2e-9);
  }
  const auto is_offered = [] { return topics_published_by(kNode).count("/paths/red_cup") > 0; };
  ASSERT_TRUE(is_offered());
  EXPECT_TRUE(client.wait_until([&] { return !is_offered(); })) << "the object is gone";
}

TEST_F(NodeHealthTest, P27_markers_of_vanished_objects_are_deleted_and_no_other) {
  std::map<std::pair<std::string, int>, int> shown;
  int unknown_deletions = 0;
  int deletions_of_all = 0;
  const auto markers = node.subscribe<visualization_msgs::MarkerArray>("markers", 50, [&](const auto& message) {
    for (const Marker& marker : message->markers) {
      deletions_of_all += marker.action == Marker::DELETEALL ? 1 : 0;
      if (marker.action == Marker::ADD) {
        shown[{marker.ns, marker.id}] = 1;
      } else if (marker.action == Marker::DELETE) {
        unknown_deletions += shown.erase({marker.ns, marker.id}) == 0 ? 1 : 0;
      }
    }
  });
  ASSERT_TRUE(client.wait_until([&] { return markers.getNumPublishers() > 0; }));
  client.stream({{"a", high_flight()}, {"b", high_flight(3.0)}, {"c", high_flight(6.0)}}, 12);
  EXPECT_TRUE(client.wait_until([&] { return shown.size() == 3U * (2U + 3U); })) << "path, label, ghosts at 4, 8, 12";
  client.stream({{"b", high_flight(3.0)}}, 40);
  EXPECT_TRUE(client.wait_until([&] { return shown.size() == 5U; }));
  EXPECT_EQ(shown.count({"path/b", 0}), 1U);
  EXPECT_TRUE(client.wait_until([&] { return shown.empty(); })) << "nothing is left of an empty scene";
  EXPECT_EQ(unknown_deletions, 0);
  EXPECT_EQ(deletions_of_all, 0) << "they would make the display flicker";
}

TEST_F(NodeHealthTest, P28_no_transform_is_published) {
  client.stream({{"a", high_flight()}}, 12);
  ASSERT_TRUE(forecast_reaches_the_last_cloud());
  const std::set<std::string> topics = topics_published_by(kNode);
  EXPECT_EQ(topics.count("/forecast"), 1U);
  EXPECT_EQ(topics.count("/tf"), 0U);
  EXPECT_EQ(topics.count("/tf_static"), 0U);
}

// The node sends 20 clouds of 1.7 MB to the sleeper: more than the buffers between the two processes hold.
TEST_F(NodeHealthTest, P29_a_subscriber_that_sleeps_holds_nobody_up) {
  const int pid = node_pid("/sleeper");
  ASSERT_GT(pid, 0);
  ASSERT_EQ(topics_of("/sleeper", Role::kSubscriber).count("/forecast_cloud"), 1U);
  ASSERT_EQ(kill(pid, SIGSTOP), 0);
  client.object("large");
  EXPECT_TRUE(client.wait_until(
      [&] {
        client.object("large").publish(stamped_cloud(blob(6000), ros::Time::now()));
        client.wait_until([] { return false; }, 1.0 / 30.0);
        return client.num_forecasts >= 20;
      },
      60.0));
  EXPECT_EQ(kill(pid, SIGCONT), 0);
}

TEST_F(NodeHealthTest, P19_threads_do_not_multiply) {
  client.stream({{"a", high_flight()}}, 12);
  const int pid = node_pid(kNode);
  ASSERT_GT(pid, 0);
  const int threads = num_threads_of(pid);
  ASSERT_GT(threads, 5);
  EXPECT_LE(threads, 24) << "lanes, services, tf, roscpp and one for the model";
  client.stream({{"a", high_flight()}, {"b", high_flight(3.0)}, {"c", high_flight(6.0)}}, 12);
  client.call({});
  EXPECT_EQ(num_threads_of(pid), threads);
}

TEST_F(NodeHealthTest, P35_a_tilted_camera_sees_the_same_fall) {
  const RigidTransform T_world_camera{
      Eigen::Quaterniond(Eigen::AngleAxisd(2.0, Eigen::Vector3d(1.0, 2.0, -0.5).normalized())), {1.0, -2.0, 3.0}};
  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(camera_at("tilted_camera", T_world_camera));
  const auto in_camera = [&](double t) {
    ObjectClouds scene = scene_at(t, without_spin(high_flight()));
    const Points seen = T_world_camera.inverse().apply(without_spin(high_flight()).pose(t).apply(blob()));
    scene.clouds = {to_cloud(seen)};
    scene.header.frame_id = "tilted_camera";
    return scene;
  };
  Rollout::Request r;
  r.scene = in_camera(0.04);
  r.previous_scene = in_camera(0.0);
  r.time_step = 0.04;
  r.num_steps = 12;
  Response tilted;
  ASSERT_TRUE(client.wait_until([&] {
    tilted = client.call(r);
    return tilted.success;
  })) << tilted.message;
  r.scene = scene_at(0.04, without_spin(high_flight()));
  r.previous_scene = scene_at(0.0, without_spin(high_flight()));
  const Response upright = client.call(r);
  ASSERT_TRUE(upright.success) << upright.message;
  EXPECT_EQ(tilted.forecast.header.frame_id, "world");
  for (std::size_t k = 0; k < upright.forecast.times.size(); ++k) {
    const RigidTransform a = to_transform(tilted.forecast.objects.at(0).poses.at(k));
    const RigidTransform b = to_transform(upright.forecast.objects.at(0).poses.at(k));
    EXPECT_LT((a.translation - b.translation).norm(), 1e-4) << k;
  }
}

TEST_F(NodeHealthTest, ValuesOfTheYamlFileSurviveTheStart) {
  int num_steps = 0;
  int ghost_every = 0;
  double max_input_age = 0.0;
  double point_size = 0.0;
  const auto read = [&](const char* name, auto& value) { return ros::param::get(std::string(kNode) + name, value); };
  ASSERT_TRUE(read("/predict/num_steps", num_steps) && read("/display/ghost_every", ghost_every) &&
              read("/diagnostics/max_input_age", max_input_age) && read("/display/point_size", point_size));
  EXPECT_EQ(num_steps, 12);
  EXPECT_EQ(ghost_every, 4);
  EXPECT_EQ(max_input_age, 2.0);
  EXPECT_EQ(point_size, DisplayParameters().point_size);
  EXPECT_EQ(reconfigure("predict", {}).ints.at(0).value, 12);
}

TEST_F(NodeHealthTest, TuningChangesTheNextForecastAndIllValuesAreNotTaken) {
  dynamic_reconfigure::Config change;
  dynamic_reconfigure::IntParameter steps;
  steps.name = "num_steps";
  steps.value = 5;
  change.ints = {steps};
  EXPECT_EQ(reconfigure("predict", change).ints.at(0).value, 5);
  client.stream({{"a", high_flight()}}, 12);
  ASSERT_TRUE(forecast_reaches_the_last_cloud());
  EXPECT_EQ(client.last_forecast.times.size(), 6U);
  change.ints[0].value = 0;
  EXPECT_EQ(reconfigure("predict", change).ints.at(0).value, 1) << "clamped to the range";
  change.ints[0].value = 12;
  reconfigure("predict", change);

  dynamic_reconfigure::Config no_number;
  dynamic_reconfigure::DoubleParameter rate;
  rate.name = "rate";
  rate.value = std::numeric_limits<double>::quiet_NaN();
  no_number.doubles = {rate};
  EXPECT_EQ(reconfigure("predict", no_number).doubles.at(0).value, PredictParameters().rate) << "refused";
  client.stream({{"a", high_flight()}}, 12);
  ASSERT_TRUE(forecast_reaches_the_last_cloud());
  EXPECT_EQ(client.last_forecast.times.size(), 13U);
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "node_health_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
