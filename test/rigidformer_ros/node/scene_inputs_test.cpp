// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <malloc.h>
#include <nav_msgs/Path.h>
#include <rigidformer_ros/ObjectClouds.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include "rigidformer_ros/labelled_cloud_maker.hpp"
#include "rigidformer_ros/node/node_client.hpp"
#include "rigidformer_ros/outputs/object_publishers.hpp"

namespace rigidformer_ros::testing {
namespace {

// [m]. Stamps are rounded to nanoseconds and points to float32; after a second that makes errors of millimetres.
constexpr double kTolerance_m = 0.003;
// Pose of the camera in the fixed frame: tilted, so that clouds which are not moved out of its frame are noticed.
const RigidTransform kCamera{Eigen::Quaterniond(Eigen::AngleAxisd(-2.0, Eigen::Vector3d::UnitX())), {0.5, -4.0, 3.0}};

geometry_msgs::TransformStamped transform(const RigidTransform& T, const std::string& child, const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = "world";
  message.child_frame_id = child;
  const geometry_msgs::Pose pose = to_pose(T);
  message.transform.translation.x = pose.position.x;
  message.transform.translation.y = pose.position.y;
  message.transform.translation.z = pose.position.z;
  message.transform.rotation = pose.orientation;
  return message;
}

// Publishes scenes in the frame of a camera. The poses of the flights are those of a tracker, whose object frames have
// another origin and other axes than the node would choose.
class SceneInputsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    static_frames.sendTransform(transform(kCamera, "camera", ros::Time::now()));
    client.reset();
  }

  static Flight flight(double y) {
    Flight f;
    f.start = {0.0, y, 50.0};
    f.angular_velocity = {0.0, 0.0, 0.0};
    return f;
  }

  static Points in_camera(const Points& points_world) { return kCamera.inverse().apply(points_world); }

  void publish_poses(const std::map<std::string, RigidTransform>& T_world_object, const ros::Time& stamp) {
    for (const auto& [id, T] : T_world_object) {
      frames.sendTransform(transform(T, "track_" + id, stamp));
    }
  }

  // Publishes one frame of a scene with two flying objects, a lift that rises evenly, a table that hangs in the air,
  // and background.
  void publish_labelled(const ros::Time& stamp, double t) {
    const RigidTransform T_world_lift{Eigen::Quaterniond::Identity(), {5.0, 0.0, 1.0 + t}};
    const std::vector<std::pair<std::int64_t, Points>> parts{{1, flight(0.0).pose(t).apply(blob())},
                                                             {2, flight(3.0).pose(t).apply(blob())},
                                                             {4, T_world_lift.apply(blob())},
                                                             {9, table},
                                                             {0, Points((table.array() + 20.0F).matrix())}};
    Points all(0, 3);
    std::vector<std::int64_t> labels;
    for (const auto& [label, points] : parts) {
      all.conservativeResize(all.rows() + points.rows(), 3);
      all.bottomRows(points.rows()) = points;
      labels.resize(static_cast<std::size_t>(all.rows()), label);
    }
    sensor_msgs::PointCloud2 message = LabelledCloudMaker().make(in_camera(all), labels);
    message.header.stamp = stamp;
    message.header.frame_id = camera_frame;
    publish_poses({{"cup", flight(0.0).pose(t)}, {"obj_2", flight(3.0).pose(t)}, {"lift", T_world_lift}}, stamp);
    labelled.publish(message);
  }

  void publish_scene(const ros::Time& stamp, double t) {
    ObjectClouds message;
    message.header.stamp = stamp;
    message.header.frame_id = "camera";
    message.ids = {"a", "broken", "b"};
    for (const double y : {0.0, 3.0, 6.0}) {
      message.clouds.push_back(to_cloud(in_camera(flight(y).pose(t).apply(blob()))));
      message.poses.push_back(to_pose(kCamera.inverse() * flight(y).pose(t)));
    }
    message.clouds[1].data.clear();
    scenes.publish(message);
  }

  template <typename Publish>
  void stream(const Publish& publish, int frames_count = 15) {
    flight_start = ros::Time::now();
    for (int i = 0; i < frames_count; ++i) {
      last_stamp = ros::Time::now();
      publish(last_stamp, (last_stamp - flight_start).toSec());
      client.wait_until([] { return false; }, 1.0 / 30.0);
    }
    ASSERT_TRUE(client.wait_until([&] { return client.last_forecast.header.stamp == last_stamp; }));
  }

  std::map<std::string, ObjectForecast> forecasts() const {
    std::map<std::string, ObjectForecast> by_id;
    for (const ObjectForecast& object : client.last_forecast.objects) {
      by_id[object.id] = object;
    }
    return by_id;
  }

  static NodeClient& shared_client() {
    static NodeClient instance;
    return instance;
  }

  NodeClient& client = shared_client();
  ros::NodeHandle node;
  tf2_ros::StaticTransformBroadcaster static_frames;
  tf2_ros::TransformBroadcaster frames;
  ros::Publisher labelled = node.advertise<sensor_msgs::PointCloud2>("cloud", 5);
  ros::Publisher scenes = node.advertise<ObjectClouds>("object_clouds", 5);
  const Points table = blob(40, 3);
  std::string camera_frame = "camera";
  ros::Time flight_start;
  ros::Time last_stamp;
};

TEST_F(SceneInputsTest, LabelledCloudWithFramesOfATracker) {
  ASSERT_TRUE(client.wait_until([&] { return labelled.getNumSubscribers() > 0; }));
  stream([this](const ros::Time& stamp, double t) { publish_labelled(stamp, t); });
  const auto objects = forecasts();
  ASSERT_EQ(objects.size(), 4U);
  EXPECT_LT(largest_error(client.last_forecast, "cup", flight(0.0), flight_start), kTolerance_m);
  EXPECT_LT(largest_error(client.last_forecast, "obj_2", flight(3.0), flight_start), kTolerance_m);
  EXPECT_EQ(objects.at("table").mode, ObjectClouds::STATIC);
  EXPECT_EQ(objects.at("table").poses.front(), objects.at("table").poses.back());
  EXPECT_EQ(objects.at("lift").mode, ObjectClouds::KINEMATIC);
  const double rise = objects.at("lift").poses.back().position.z - objects.at("lift").poses.front().position.z;
  EXPECT_NEAR(rise, client.last_forecast.times.back(), kTolerance_m) << "one metre per second, gravity or not";
}

// tf 1 wrote frames with a slash in front, and old drivers and bags still do.
TEST_F(SceneInputsTest, P50_AFrameWithALeadingSlashIsTheFrameWithoutIt) {
  ASSERT_TRUE(client.wait_until([&] { return labelled.getNumSubscribers() > 0; }));
  camera_frame = "/camera";
  stream([this](const ros::Time& stamp, double t) { publish_labelled(stamp, t); });
  EXPECT_LT(largest_error(client.last_forecast, "cup", flight(0.0), flight_start), kTolerance_m);
}

// The object frames are those of the tracker, so the first pose of a forecast is the newest pose that the tracker gave.
TEST_F(SceneInputsTest, ForecastsStartFromThePosesOfTheTracker) {
  ASSERT_TRUE(client.wait_until([&] { return labelled.getNumSubscribers() > 0; }));
  stream([this](const ros::Time& stamp, double t) { publish_labelled(stamp, t); });
  const RigidTransform expected = flight(0.0).pose((last_stamp - flight_start).toSec());
  const RigidTransform actual = to_transform(forecasts().at("cup").poses.front());
  EXPECT_LT((actual.translation - expected.translation).norm(), 1e-6);
}

TEST_F(SceneInputsTest, ObjectCloudsWithPosesLoseOnlyTheBadObject) {
  ASSERT_TRUE(client.wait_until([&] { return scenes.getNumSubscribers() > 0; }));
  stream([this](const ros::Time& stamp, double t) { publish_scene(stamp, t); });
  ASSERT_EQ(forecasts().size(), 2U);
  EXPECT_LT(largest_error(client.last_forecast, "a", flight(0.0), flight_start), kTolerance_m);
  EXPECT_LT(largest_error(client.last_forecast, "b", flight(6.0), flight_start), kTolerance_m);
}

TEST_F(SceneInputsTest, P05_ALostTrackerLosesTheObjectUntilItIsBack) {
  ASSERT_TRUE(client.wait_until([&] { return labelled.getNumSubscribers() > 0; }));
  sensor_msgs::PointCloud2 message = LabelledCloudMaker().make(in_camera(blob()), std::vector<std::int64_t>(30, 77));
  message.header.frame_id = "camera";
  message.header.stamp = ros::Time::now();
  labelled.publish(message);  // The tracker never says where the frame track_obj_77 is.
  EXPECT_FALSE(client.wait_until([&] { return client.num_forecasts > 0; }, 0.5));
  stream([this](const ros::Time& stamp, double t) { publish_labelled(stamp, t); });
  EXPECT_EQ(forecasts().count("obj_77"), 0U);
  EXPECT_EQ(forecasts().count("cup"), 1U);
}

// roscpp keeps 300 bytes for every topic that a node handle ever offered. ObjectPublishers must not gather them.
TEST(ObjectPublishers, P18_objects_that_come_and_go_leave_no_memory_behind) {
  ObjectPublishers<nav_msgs::Path> publishers(ros::NodeHandle(), [](const std::string& id) { return "passing/" + id; });
  const auto come_and_go = [&](int times) {
    for (int i = 0; i < times; ++i) {
      publishers.set_objects({"a"});
      publishers.set_objects({});
    }
  };
  come_and_go(20);  // The first rounds allocate what is kept for good.
  const auto before = static_cast<double>(::mallinfo2().uordblks);
  come_and_go(100);
  EXPECT_LT(static_cast<double>(::mallinfo2().uordblks) - before, 100 * 100.0);
}

}  // namespace
}  // namespace rigidformer_ros::testing

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "scene_inputs_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
