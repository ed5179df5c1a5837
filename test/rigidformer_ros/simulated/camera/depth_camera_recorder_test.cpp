// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/camera/depth_camera_recorder.hpp"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <filesystem>
#include <map>

#include "rigidformer_ros/messages/conversions.hpp"
#include "rigidformer_ros/messages/labelled_cloud.hpp"
#include "rigidformer_ros/simulated/camera/camera_messages.hpp"

namespace rigidformer_ros::camera {
namespace {

CameraOptions small_options() {
  CameraOptions options;
  options.scene_set = "movi_a";
  options.duration = 0.2;
  options.width = 96;
  options.height = 72;
  options.num_scenes = 2;
  options.object_clouds = options.object_frames = true;
  return options;
}

class DepthCameraRecorder : public ::testing::Test {
 protected:
  ~DepthCameraRecorder() override { std::filesystem::remove(file); }

  template <typename Message>
  std::vector<Message> messages(const std::string& topic) const {
    std::vector<Message> found;
    rosbag::Bag bag(file);
    for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery(topic))) {
      found.push_back(*instance.instantiate<Message>());
    }
    return found;
  }

  const std::string file = ::testing::TempDir() + "depth_camera_" + std::to_string(::getpid()) + ".bag";
};

TEST_F(DepthCameraRecorder, HoldsEveryFrameWithItsStampAsTime) {
  const RecordingSummary summary = record_bag(file, small_options());
  EXPECT_EQ(summary.num_scenes, 2);
  EXPECT_EQ(summary.num_frames, 2 * 7);
  rosbag::Bag bag(file);
  std::map<std::string, int> counts;
  ros::Time last;
  for (const rosbag::MessageInstance& instance : rosbag::View(bag)) {
    ++counts[instance.getTopic()];
    EXPECT_GE(instance.getTime(), last);
    last = instance.getTime();
    if (const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>()) {
      EXPECT_EQ(cloud->header.stamp, instance.getTime());
      EXPECT_EQ(cloud->header.frame_id, "camera_optical");
    }
  }
  const std::map<std::string, int> expected{
      {"/cloud", 14}, {"/object_clouds", 14}, {"/tf", 14}, {"/tf_static", 1}, {"/camera/truth", 2}};
  EXPECT_EQ(counts, expected);
}

TEST_F(DepthCameraRecorder, StaticFrameAndTruthAreLatched) {
  record_bag(file, small_options());
  rosbag::Bag bag(file);
  rosbag::View view(bag);
  int latched = 0;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    const auto latching = connection->header->find("latching");
    latched += latching != connection->header->end() && latching->second == "1";
  }
  EXPECT_EQ(latched, 2);
}

TEST_F(DepthCameraRecorder, CloudsPosesAndFramesTellOfTheSameObjects) {
  record_bag(file, small_options());
  const auto T_world_camera =
      to_transform(messages<tf2_msgs::TFMessage>("/tf_static").at(0).transforms.at(0).transform);
  const auto clouds = messages<sensor_msgs::PointCloud2>("/cloud");
  const auto scenes = messages<ObjectClouds>("/object_clouds");
  const auto frames = messages<tf2_msgs::TFMessage>("/tf");
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    const std::vector<LabelPoints> parts = split_by_label(clouds[i], read_points(clouds[i], 1000000));
    ASSERT_EQ(parts.size(), scenes[i].ids.size());
    ASSERT_EQ(parts.size(), frames[i].transforms.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      EXPECT_EQ(scenes[i].ids[k], "obj_" + std::to_string(parts[k].label));
      EXPECT_EQ(frames[i].transforms[k].child_frame_id, "object_" + scenes[i].ids[k]);
      EXPECT_EQ(read_points(scenes[i].clouds[k], 1000000), parts[k].points);
      const auto through_camera = T_world_camera * to_transform(scenes[i].poses[k]);
      const auto direct = to_transform(frames[i].transforms[k].transform);
      EXPECT_LT((through_camera.translation - direct.translation).norm(), 1e-9);
      EXPECT_LT(rigidformer::rotation_angle(through_camera.rotation, direct.rotation), 1e-6);
    }
  }
}

TEST_F(DepthCameraRecorder, ABareCameraHasNoLabelsAndTellsNothingElse) {
  CameraOptions options = small_options();
  options.labels = options.object_clouds = options.object_frames = false;
  record_bag(file, options);
  EXPECT_EQ(messages<sensor_msgs::PointCloud2>("/cloud").at(0).fields.size(), 3U);
  EXPECT_TRUE(messages<ObjectClouds>("/object_clouds").empty());
  EXPECT_TRUE(messages<tf2_msgs::TFMessage>("/tf").empty());
}

TEST_F(DepthCameraRecorder, TheSameSeedGivesTheSameClouds) {
  record_bag(file, small_options());
  const auto first = messages<sensor_msgs::PointCloud2>("/cloud");
  record_bag(file, small_options());
  EXPECT_EQ(messages<sensor_msgs::PointCloud2>("/cloud"), first);
}

TEST_F(DepthCameraRecorder, UnusableOptionsAndFilesAreErrors) {
  CameraOptions options = small_options();
  options.num_scenes = 0;
  EXPECT_THROW(record_bag(file, options), std::invalid_argument);
  EXPECT_THROW(record_bag("/nowhere/file.bag", small_options()), std::runtime_error);
}

}  // namespace
}  // namespace rigidformer_ros::camera
