// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/inputs/scene_intake.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <vector>

#include "rigidformer_ros/inputs/frame_transformer.hpp"
#include "rigidformer_ros/labelled_cloud_maker.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/messages/conversions.hpp"
#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

using rigidformer::MotionMode;
using rigidformer::ObservedObject;
using testing::blob;
using testing::LabelledCloudMaker;

// Time of the clock [s] during all tests; any time but 0, which means that the clock has not started.
const ros::Time kNow(100.0);
// Pose of the camera in the fixed frame, turned so that clouds which are not moved out of its frame are noticed.
const RigidTransform kCamera{Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX())), {1.0, 2.0, 3.0}};

class SceneIntakeTest : public ::testing::Test {
 protected:
  SceneIntakeTest() {
    ros::Time::init();
    ros::Time::setNow(kNow);
    frames["camera"] = kCamera;
    parameters.input.label_names = {{2, "table", MotionMode::kStatic, {}}, {3, "cup", MotionMode::kKinematic, {}}};
  }

  // Answers as tf would: asking for a frame that does not exist takes the whole timeout.
  RigidTransform look_up(const std::string& frame, double timeout_s) {
    const auto found = frames.find(frame);
    if (found == frames.end()) {
      waits_s.push_back(timeout_s);
      ros::WallDuration(timeout_s).sleep();
      throw TransformError("no transform from '" + frame + "' to 'world'");
    }
    return found->second;
  }

  SceneIntake intake() {
    return {parameters,
            [this](const std::string& frame, const ros::Time&, double timeout_s) { return look_up(frame, timeout_s); },
            {scene, rejections, monitor, timing}};
  }

  static sensor_msgs::PointCloud2 labelled(const std::vector<std::int64_t>& labels, int points_each = 10) {
    std::vector<std::int64_t> all;
    for (const std::int64_t label : labels) {
      all.insert(all.end(), static_cast<std::size_t>(points_each), label);
    }
    sensor_msgs::PointCloud2 cloud = LabelledCloudMaker().make(blob(static_cast<int>(all.size())), all);
    cloud.header.stamp = kNow;
    cloud.header.frame_id = "camera";
    return cloud;
  }

  static ObjectClouds scene_message(const std::vector<std::string>& ids) {
    ObjectClouds message;
    message.header.stamp = kNow;
    message.header.frame_id = "camera";
    message.ids = ids;
    message.clouds.assign(ids.size(), to_cloud(blob(10)));
    return message;
  }

  std::map<std::string, ObservedObject> objects() const {
    std::map<std::string, ObservedObject> found;
    for (const ObservedObject& object : scene.snapshot(0.04).objects) {
      found[object.state.id] = object;
    }
    return found;
  }

  std::string report() {
    std::string text;
    for (const std::string& line : rejections.take_report()) {
      text += line + "\n";
    }
    return text;
  }

  NodeParameters parameters;
  RejectionLog rejections;
  InputMonitor monitor;
  TimingMonitor timing;
  LiveScene scene{parameters, rejections};
  std::map<std::string, RigidTransform> frames;
  std::vector<double> waits_s;
};

Points world_points(const ObservedObject& object) {
  return object.state.T_world_current.apply(object.state.points_reference);
}

TEST_F(SceneIntakeTest, LabelsBecomeObjectsWithNamesAndModes) {
  intake().take_labelled("/cloud", labelled({0, 1, 2, 3}));
  const auto seen = objects();
  ASSERT_EQ(seen.size(), 3U) << report();
  EXPECT_EQ(seen.at("obj_1").state.mode, MotionMode::kDynamic);
  EXPECT_EQ(seen.at("table").state.mode, MotionMode::kStatic);
  EXPECT_EQ(seen.at("cup").state.mode, MotionMode::kKinematic);
  const Points expected = kCamera.apply(blob(40).middleRows(10, 10));
  EXPECT_LT((world_points(seen.at("obj_1")) - expected).cwiseAbs().maxCoeff(), 1e-5F);
  EXPECT_EQ(report(), "");
}

TEST_F(SceneIntakeTest, PropertiesComeFromTheLabelThenTheRules) {
  parameters.input.label_names[1].properties.mass_kg = 0.3;
  parameters.properties.objects = {{"c*", {0.1, 0.7, {}}}};
  intake().take_labelled("/cloud", labelled({3}));
  const auto cup = objects().at("cup").state.properties;
  EXPECT_EQ(cup.mass_kg, 0.3);
  EXPECT_EQ(cup.friction, 0.7);
  EXPECT_FALSE(cup.restitution.has_value());
}

TEST_F(SceneIntakeTest, TooSmallOrTooLargePartsLoseOnlyThemselves) {
  parameters.input.max_points = 20;
  // Of the 45 points, 30 get label 8 (too many points), 3 get label 9 (too few), and 12 get label 1.
  std::vector<std::int64_t> labels(45, 8);
  std::fill(labels.begin() + 30, labels.begin() + 33, 9);
  std::fill(labels.begin() + 33, labels.end(), 1);
  sensor_msgs::PointCloud2 cloud = LabelledCloudMaker().make(blob(45), labels);
  cloud.header = labelled({1}).header;
  intake().take_labelled("/cloud", cloud);
  EXPECT_EQ(objects().size(), 1U);
  EXPECT_EQ(objects().count("obj_1"), 1U);
  EXPECT_EQ(rejections.counts()["malformed cloud"].total, 1U);
  EXPECT_EQ(rejections.counts()["too few points"].total, 1U);
  EXPECT_NE(report().find("'obj_8': has 30 finite points"), std::string::npos);
}

TEST_F(SceneIntakeTest, P05_MissingFrameIsCountedAndNamed) {
  parameters.tf_timeout = 0.0;
  sensor_msgs::PointCloud2 cloud = labelled({1});
  cloud.header.frame_id = "nowhere";
  intake().take_labelled("/cloud", cloud);
  ObjectClouds message = scene_message({"a"});
  message.header.frame_id = "nowhere";
  intake().take_scene("/object_clouds", message);
  EXPECT_TRUE(objects().empty());
  EXPECT_EQ(rejections.counts()["no transform"].total, 2U);
  EXPECT_NE(report().find("'nowhere' to 'world'"), std::string::npos);
}

TEST_F(SceneIntakeTest, P06_ImpossibleStampIsCountedOncePerMessage) {
  sensor_msgs::PointCloud2 cloud = labelled({1, 2, 3});
  cloud.header.stamp = ros::Time(0.0);
  intake().take_labelled("/cloud", cloud);
  ObjectClouds message = scene_message({"a", "b"});
  message.header.stamp = kNow + ros::Duration(60.0);
  intake().take_scene("/object_clouds", message);
  EXPECT_TRUE(objects().empty());
  EXPECT_EQ(rejections.counts()["bad stamp"].total, 2U);
}

TEST_F(SceneIntakeTest, SceneMessageGivesModesPosesAndMaterial) {
  ObjectClouds message = scene_message({"a", "b"});
  message.modes = {ObjectClouds::STATIC, ObjectClouds::DYNAMIC};
  const RigidTransform T_camera_a{Eigen::Quaterniond::Identity(), {0.5, 0.0, 0.0}};
  message.poses = {to_pose(T_camera_a), to_pose(RigidTransform())};
  message.properties.resize(2);
  message.properties[1].known = PhysicalProperties::FRICTION;
  message.properties[1].friction = 0.25;
  intake().take_scene("/object_clouds", message);
  const auto seen = objects();
  ASSERT_EQ(seen.size(), 2U) << report();
  EXPECT_EQ(seen.at("a").state.mode, MotionMode::kStatic);
  EXPECT_LT((seen.at("a").state.T_world_current.translation - kCamera * Eigen::Vector3d(0.5, 0.0, 0.0)).norm(), 1e-9);
  EXPECT_EQ(seen.at("b").state.properties.friction, 0.25);
  EXPECT_FALSE(seen.at("b").state.properties.mass_kg.has_value());
}

TEST_F(SceneIntakeTest, AnEmptySceneMessageMeansThatNothingWasSeen) {
  intake().take_scene("/object_clouds", ObjectClouds());
  EXPECT_EQ(report(), "");
}

TEST_F(SceneIntakeTest, P03_OneBadObjectDoesNotHinderTheOthers) {
  const std::vector<std::function<void(ObjectClouds&)>> damages{[](ObjectClouds& m) { m.clouds[1].row_step = 1; },
                                                                [](ObjectClouds& m) { m.clouds[1].data.clear(); },
                                                                [](ObjectClouds& m) { m.clouds[1].fields.clear(); },
                                                                [](ObjectClouds& m) { m.ids[1] = ""; },
                                                                [](ObjectClouds& m) { m.ids[1] = "a"; },
                                                                [](ObjectClouds& m) { m.modes[1] = 7; },
                                                                [](ObjectClouds& m) { m.poses[1].orientation.w = 0; },
                                                                [](ObjectClouds& m) { m.properties[1].mass = -1; }};
  for (std::size_t i = 0; i < damages.size(); ++i) {
    ObjectClouds message = scene_message({"a", "bad", "c"});
    message.modes.assign(3, ObjectClouds::DYNAMIC);
    message.poses.assign(3, to_pose(RigidTransform()));
    message.properties.resize(3);
    message.properties[1].known = PhysicalProperties::MASS;
    message.properties[1].mass = 1.0;
    damages[i](message);
    scene.reset();
    intake().take_scene("/object_clouds", message);
    const auto seen = objects();
    EXPECT_EQ(seen.size(), 2U) << "damage " << i;
    EXPECT_TRUE(seen.count("a") == 1 && seen.count("c") == 1) << "damage " << i;
    EXPECT_EQ(rejections.counts()["malformed cloud"].total, i + 1) << "damage " << i;
  }
}

TEST_F(SceneIntakeTest, P03_ArraysThatDoNotBelongTogetherRefuseTheMessage) {
  const std::vector<std::function<void(ObjectClouds&)>> damages{
      [](ObjectClouds& m) { m.clouds.pop_back(); }, [](ObjectClouds& m) { m.modes.resize(1); },
      [](ObjectClouds& m) { m.poses.resize(3); }, [](ObjectClouds& m) { m.properties.resize(1); },
      [](ObjectClouds& m) { m.ids.clear(); }};
  for (std::size_t i = 0; i < damages.size(); ++i) {
    ObjectClouds message = scene_message({"a", "b"});
    damages[i](message);
    intake().take_scene("/object_clouds", message);
    EXPECT_TRUE(objects().empty()) << "damage " << i;
    EXPECT_EQ(rejections.counts()["malformed cloud"].total, i + 1) << "damage " << i;
  }
}

TEST_F(SceneIntakeTest, PosesComeFromFramesOfTheTracker) {
  parameters.input.pose_frame_prefix = "track_";
  const RigidTransform T_world_object{Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ())),
                                      {1.0, 1.0, 1.0}};
  frames["track_obj_1"] = T_world_object;
  intake().take_labelled("/cloud", labelled({1, 2}));
  const auto seen = objects();
  ASSERT_EQ(seen.size(), 2U) << "a static object needs no tracker: " << report();
  EXPECT_LT((seen.at("obj_1").state.T_world_current.translation - T_world_object.translation).norm(), 1e-12);
  EXPECT_LT(rigidformer::rotation_angle(seen.at("obj_1").state.T_world_current.rotation, T_world_object.rotation),
            1e-7);
}

TEST_F(SceneIntakeTest, PosesInTheMessageWinOverFrames) {
  parameters.input.pose_frame_prefix = "track_";
  frames["track_a"] = RigidTransform{Eigen::Quaterniond::Identity(), {9.0, 9.0, 9.0}};
  ObjectClouds message = scene_message({"a"});
  message.poses = {to_pose(RigidTransform())};
  intake().take_scene("/object_clouds", message);
  EXPECT_LT((objects().at("a").state.T_world_current.translation - kCamera.translation).norm(), 1e-9);
}

TEST_F(SceneIntakeTest, P05_MissingPosesAreNamedAndShareOneWait) {
  parameters.input.pose_frame_prefix = "track_";
  parameters.tf_timeout = 0.05;
  intake().take_scene("/object_clouds", scene_message({"a", "b", "c", "d"}));
  EXPECT_TRUE(objects().empty());
  EXPECT_EQ(rejections.counts()["no pose"].total, 4U);
  EXPECT_NE(report().find("'track_d' to 'world'"), std::string::npos);
  ASSERT_EQ(waits_s.size(), 4U);
  for (std::size_t i = 1; i < waits_s.size(); ++i) {
    EXPECT_EQ(waits_s[i], 0.0);
  }
}

}  // namespace
}  // namespace rigidformer_ros
