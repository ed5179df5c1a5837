// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rosgraph_msgs/Log.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <visualization_msgs/MarkerArray.h>

#include <limits>

#include "rigidformer_ros/node/node_client.hpp"
#include "rigidformer_ros/node/rollout_requests.hpp"

namespace rigidformer_ros::testing {
namespace {

class PredictionNodeTest : public ::testing::Test {
 protected:
  void SetUp() override { client.start_afresh(); }

  // Streams clouds of the flights. Requests can be about the last state for `max_state_age` afterwards.
  void stream(const std::map<std::string, Flight>& flights, int frames = 18) {
    client.stream(flights, frames);
    flight_start = client.flight_start;
    last_stamp = client.last_stamp;
  }

  // The default request, except that it accepts an older state: on a slow machine it may come late.
  static Rollout::Request request() {
    Rollout::Request r;
    r.max_state_age = ros::Duration(30.0);
    return r;
  }

  // [m]. Stamps are rounded to nanoseconds and points to float32; after a second that makes errors of millimetres.
  static constexpr double kTolerance_m = 0.003;

  // The error [m] that the spinning flight has after this time because the predictor knows the centre of mass only to
  // `centre_of_mass_error` [m].
  static double drift_m(double seconds) {
    const double angle = high_flight().angular_velocity.norm() * seconds;
    return ros::param::param("~centre_of_mass_error", 0.0) * drift_of_wrong_centre(angle);
  }

  static NodeClient& shared_client() {
    static NodeClient instance;
    return instance;
  }

  NodeClient& client = shared_client();
  ros::Time flight_start;
  ros::Time last_stamp;
};

TEST_F(PredictionNodeTest, P26_forecast_matches_the_parabola_at_the_stated_times) {
  stream({{"a", without_spin(high_flight())}, {"b", without_spin(high_flight(3.0))}});
  ASSERT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == last_stamp; }));
  const SceneForecast& forecast = client.last_forecast;
  EXPECT_EQ(forecast.header.frame_id, "world");
  ASSERT_EQ(forecast.times.size(), 25U);
  EXPECT_EQ(forecast.times[0], 0.0);
  EXPECT_NEAR(forecast.times[24], 1.0, 1e-9);
  ASSERT_EQ(forecast.objects.size(), 2U);
  for (const ObjectForecast& object : forecast.objects) {
    EXPECT_EQ(object.status, ObjectForecast::OK);
    const Flight flight = without_spin(high_flight(object.id == "a" ? 0.0 : 3.0));
    EXPECT_LT(largest_error(forecast, object.id, flight, flight_start), kTolerance_m);
  }
}

// A predictor that has to guess the centre of mass from the cloud moves a wrong point along the parabola.
TEST_F(PredictionNodeTest, ASpinningBodyDriftsByTheErrorOfItsCentreOfMassOnly) {
  stream({{"a", high_flight()}});
  ASSERT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == last_stamp; }));
  EXPECT_LT(largest_error(client.last_forecast, "a", high_flight(), flight_start), kTolerance_m + drift_m(1.0));
}

TEST_F(PredictionNodeTest, ServiceEqualsTopicForTheSameState) {
  stream({{"a", high_flight()}, {"b", high_flight(3.0)}});
  ASSERT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == last_stamp; }));
  const Response response = client.call(request());
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.error_code, Response::SUCCESS);
  EXPECT_EQ(response.steps_done, 24U);
  EXPECT_EQ(response.forecast.header.stamp, client.last_forecast.header.stamp);
  EXPECT_EQ(response.forecast.times, client.last_forecast.times);
  EXPECT_EQ(response.forecast.objects, client.last_forecast.objects);
  EXPECT_EQ(client.call(request()).forecast.objects, response.forecast.objects) << "a query changes nothing";
}

TEST_F(PredictionNodeTest, TimeStepAndRecordingChangeTheSpacing) {
  stream({{"a", without_spin(high_flight())}, {"b", high_flight(3.0)}});
  Rollout::Request r = request();
  r.time_step = 0.01;
  r.num_steps = 70;
  r.record_every = 7;
  r.return_points = true;
  const Response response = client.call(r);
  ASSERT_TRUE(response.success) << response.message;
  ASSERT_EQ(response.forecast.times.size(), 11U);
  EXPECT_NEAR(response.forecast.times[1], 0.07, 1e-12);
  EXPECT_EQ(response.forecast.time_step, 0.01);
  EXPECT_LT(largest_error(response.forecast, "a", without_spin(high_flight()), flight_start), 3.0 * kTolerance_m);
  EXPECT_LT(largest_error(response.forecast, "b", high_flight(3.0), flight_start), 3.0 * (kTolerance_m + drift_m(0.7)));
  EXPECT_EQ(response.points.width, 2U * 11U * 30U);
  EXPECT_EQ(response.points.header, response.forecast.header);
}

TEST_F(PredictionNodeTest, ReportsOnlyTheRequestedObjects) {
  stream({{"a", high_flight()}, {"b", high_flight(3.0)}});
  Rollout::Request r = request();
  r.object_ids = {"b"};
  const Response response = client.call(r);
  ASSERT_TRUE(response.success) << response.message;
  ASSERT_EQ(response.forecast.objects.size(), 1U);
  EXPECT_EQ(response.forecast.objects[0].id, "b");
}

TEST_F(PredictionNodeTest, StatelessQueryUsesTheGivenCloudsOnly) {
  stream({{"a", high_flight()}});
  Flight flight = high_flight();
  flight.gravity = 0.0;  // Until the observation the object moves evenly, so its velocity is exactly known.
  Rollout::Request r;
  r.scene = scene_at(0.04, flight);
  r.previous_scene = scene_at(0.0, flight);
  r.time_step = 0.04;
  r.num_steps = 20;
  Response response = client.call(r);
  ASSERT_TRUE(response.success) << response.message;
  ASSERT_EQ(response.forecast.objects.size(), 1U);
  EXPECT_EQ(response.forecast.header.stamp, ros::Time(50.04));
  EXPECT_EQ(response.forecast.objects[0].status, ObjectForecast::OK);
  EXPECT_NEAR(response.forecast.objects[0].twists[0].linear.z, 4.0, 0.05);
  r.previous_scene = ObjectClouds();
  response = client.call(r);
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.forecast.objects[0].status, ObjectForecast::ASSUMED_STATIC);
  EXPECT_EQ(client.call(request()).forecast.objects.at(0).id, "a") << "the live state is untouched";
}

TEST_F(PredictionNodeTest, P24_bad_requests_get_their_code_and_a_sentence_naming_the_field) {
  stream({{"a", high_flight()}});
  for (const BadRequest& bad : kBadRequests) {
    Rollout::Request r = request();
    bad.change(r);
    const Response response = client.call(r);
    EXPECT_FALSE(response.success) << bad.name;
    EXPECT_EQ(response.error_code, bad.code) << bad.name << ": " << response.message;
    EXPECT_NE(response.message.find(bad.part), std::string::npos) << bad.name << ": " << response.message;
  }
  EXPECT_TRUE(client.call(request()).success) << "and the next good one is answered";
}

TEST_F(PredictionNodeTest, AFreshOrResetNodeKnowsNoObjects) {
  EXPECT_EQ(client.call(request()).error_code, Response::NO_OBJECTS);
  stream({{"a", high_flight()}});
  ASSERT_TRUE(client.call(request()).success);
  client.reset();
  EXPECT_EQ(client.call(request()).error_code, Response::NO_OBJECTS);
  stream({{"a", high_flight()}}, 1);
  EXPECT_TRUE(client.wait_until([&] { return client.call(request()).error_code == Response::INSUFFICIENT_HISTORY; }));
  // A forecast that was under way when the reset came may still arrive.
  ASSERT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == last_stamp; }));
  EXPECT_EQ(client.last_forecast.objects.at(0).status, ObjectForecast::ASSUMED_STATIC);
}

TEST_F(PredictionNodeTest, SurvivesEmptyAndMalformedClouds) {
  ros::Publisher& bad = client.object("bad");
  const ros::Time now = ros::Time::now();
  sensor_msgs::PointCloud2 cloud = stamped_cloud(blob(), now);
  bad.publish(stamped_cloud(Points(0, 3), now));
  bad.publish(sensor_msgs::PointCloud2());
  bad.publish(stamped_cloud(Points::Constant(30, 3, std::numeric_limits<float>::quiet_NaN()), now));
  bad.publish(stamped_cloud(Points::Constant(30, 3, std::numeric_limits<float>::infinity()), now));
  bad.publish(stamped_cloud(blob(), now + ros::Duration(60.0)));
  bad.publish(stamped_cloud(blob(), now, ""));
  cloud.data.resize(17);
  bad.publish(cloud);
  cloud.width = cloud.height = 0xffffffff;
  bad.publish(cloud);
  stream({{"a", high_flight()}});
  const Response response = client.call(request());
  ASSERT_TRUE(response.success) << response.message;
  ASSERT_EQ(response.forecast.objects.size(), 1U);
  EXPECT_EQ(response.forecast.objects[0].id, "a");
}

// Twenty points in a row, one centimetre apart.
Points wire() {
  Points points = Points::Zero(20, 3);
  points.col(0).setLinSpaced(0.0F, 0.19F);
  return points;
}

TEST_F(PredictionNodeTest, P38_AnObjectThatCannotBePredictedIsSkippedAloneAndCounted) {
  ros::NodeHandle node;
  std::string log;
  const ros::Subscriber log_messages = node.subscribe<rosgraph_msgs::Log>(
      "/rosout", 100, [&](const rosgraph_msgs::Log::ConstPtr& message) { log += message->msg + '\n'; });
  ros::Publisher& thin = client.object("thin");
  const auto is_skipped = [&] {
    const SceneForecast& forecast = client.last_forecast;
    return forecast.objects.size() == 1 && forecast.objects[0].id == "a" &&
           forecast.skipped_ids == std::vector<std::string>({"thin"}) &&
           forecast.skip_reasons.at(0).find("line") != std::string::npos;
  };
  const bool was_skipped = client.wait_until([&] {
    thin.publish(stamped_cloud(wire(), ros::Time::now()));
    stream({{"a", high_flight()}}, 6);
    return is_skipped();
  });
  EXPECT_TRUE(was_skipped);
  EXPECT_TRUE(client.wait_until([&] { return log.find("Rejected, unusable object") != std::string::npos; })) << log;
}

TEST_F(PredictionNodeTest, P39_OnlyWhoAsksForAnUnusableObjectIsRefused) {
  ros::Publisher& thin = client.object("thin");
  stream({{"a", high_flight()}}, 17);
  thin.publish(stamped_cloud(wire(), ros::Time::now()));
  stream({{"a", high_flight()}}, 1);
  Rollout::Request r = request();
  r.object_ids = {"a", "thin"};
  ASSERT_TRUE(client.wait_until([&] { return client.call(r).error_code == Response::INVALID_REQUEST; }));
  const std::string message = client.call(r).message;
  EXPECT_NE(message.find("object_ids[1]: 'thin'"), std::string::npos) << message;
  EXPECT_NE(message.find("line"), std::string::npos) << message;
  r.object_ids = {"a"};
  EXPECT_NE(client.call(r).error_code, Response::INVALID_REQUEST);

  Rollout::Request given = request();
  given.scene = scene_at(0.0, high_flight());
  const Response alone = client.call(given);
  ASSERT_TRUE(alone.success) << alone.message;
  given.scene.ids.insert(given.scene.ids.begin(), "thin");
  given.scene.clouds.insert(given.scene.clouds.begin(), to_cloud(wire()));
  const Response both = client.call(given);
  EXPECT_EQ(both.error_code, Response::INVALID_REQUEST);
  EXPECT_NE(both.message.find("scene.clouds[0]: object 'thin'"), std::string::npos) << both.message;
  EXPECT_NE(both.message.find("line"), std::string::npos) << both.message;
}

TEST_F(PredictionNodeTest, WaitsForAMissingTransform) {
  ros::Publisher& camera = client.object("camera_object");
  const auto send = [&] { camera.publish(stamped_cloud(blob(), ros::Time::now(), "camera")); };
  send();
  EXPECT_FALSE(client.wait_until([&] { return client.call(request()).error_code != Response::NO_OBJECTS; }, 0.5));
  tf2_ros::StaticTransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "world";
  transform.header.stamp = ros::Time::now();
  transform.child_frame_id = "camera";
  transform.transform.translation.z = 5.0;
  transform.transform.rotation.w = 1.0;
  broadcaster.sendTransform(transform);
  ASSERT_TRUE(client.wait_until([&] {
    send();
    return client.call(request()).success;
  }));
  EXPECT_NEAR(client.call(request()).forecast.objects.at(0).poses.at(0).position.z, 5.0 + blob().col(2).mean(), 1e-3);
}

TEST_F(PredictionNodeTest, MarkersAndPointTopicsFollowTheForecast) {
  ros::NodeHandle node;
  int added = 0;
  int deleted = 0;
  std::size_t cloud_points = 0;
  std::size_t object_points = 0;
  const auto markers = node.subscribe<visualization_msgs::MarkerArray>(
      "markers", 10, [&](const visualization_msgs::MarkerArray::ConstPtr& m) {
        for (const auto& marker : m->markers) {
          ++(marker.action == visualization_msgs::Marker::DELETE ? deleted : added);
        }
      });
  const auto cloud = node.subscribe<sensor_msgs::PointCloud2>(
      "forecast_cloud", 10, [&](const sensor_msgs::PointCloud2::ConstPtr& m) { cloud_points = m->width; });
  const auto points = node.subscribe<sensor_msgs::PointCloud2>(
      "predicted/a/points", 10, [&](const sensor_msgs::PointCloud2::ConstPtr& m) { object_points = m->width; });
  stream({{"a", high_flight()}}, 30);
  EXPECT_TRUE(client.wait_until([&] { return added > 0 && cloud_points > 0 && object_points > 0; }));
  EXPECT_EQ(cloud_points, 24U * 30U);
  EXPECT_EQ(object_points, 30U);
  EXPECT_TRUE(client.wait_until([&] { return deleted > 0; })) << "markers go when the object is gone";
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "prediction_node_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
