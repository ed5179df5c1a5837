// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/demo/demo_scene.hpp"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "rigidformer_ros/simulated/demo/demo_clouds.hpp"

namespace rigidformer_ros::demo {
namespace {

DemoSceneOptions small_options() {
  DemoSceneOptions options;
  options.set = "movi_a";
  options.num_frames = 60;
  options.points_per_object = 50;
  return options;
}

TEST(DemoScene, CloudsMoveRigidlyWithTheirTruePose) {
  const DemoScene scene(small_options());
  ASSERT_GE(scene.num_objects(), 3);
  for (int object = 0; object < scene.num_objects(); ++object) {
    const rigidformer::Points later = scene.cloud_world(object, 59);
    const rigidformer::RigidTransform T_later_first =
        scene.T_world_cloud(object, 59) * scene.T_world_cloud(object, 0).inverse();
    EXPECT_LT((T_later_first.apply(scene.cloud_world(object, 0)) - later).cwiseAbs().maxCoeff(), 1e-4F);
    const Eigen::Vector3d centroid = later.cast<double>().colwise().mean();
    EXPECT_LT((centroid - scene.T_world_cloud(object, 59).translation).norm(), 1e-4);
  }
}

TEST(DemoScene, ShowsAWallOfCubesByItsCorners) {
  DemoSceneOptions options = small_options();
  options.set = "wrecking_ball_28";
  options.points_per_object = 0;
  options.num_frames = 2;
  const DemoScene scene(options);
  ASSERT_EQ(scene.num_objects(), 28);
  EXPECT_EQ(scene.cloud_world(0, 0).rows(), 8);
}

TEST(DemoScene, EveryNumberMakesAnotherScene) {
  DemoSceneOptions options = small_options();
  const DemoScene first(options);
  const DemoScene again(options);
  options.index = 1;
  const DemoScene second(options);
  EXPECT_EQ(first.cloud_world(0, 0), again.cloud_world(0, 0));
  EXPECT_NE(first.T_world_cloud(0, 0).translation, second.T_world_cloud(0, 0).translation);
}

TEST(LabelledCloud, HoldsAllObjectsWithTheirLabels) {
  const rigidformer::Points one = rigidformer::Points::Constant(2, 3, 1.0F);
  const rigidformer::Points two = rigidformer::Points::Constant(1, 3, 2.0F);
  const sensor_msgs::PointCloud2 cloud = make_labelled_cloud({one, two}, std_msgs::Header());
  ASSERT_EQ(cloud.width, 3u);
  sensor_msgs::PointCloud2ConstIterator<float> xyz(cloud, "x");
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> label(cloud, "label");
  EXPECT_EQ(label[0], 1u);
  xyz += 2;
  label += 2;
  EXPECT_FLOAT_EQ(xyz[2], 2.0F);
  EXPECT_EQ(label[0], 2u);
}

}  // namespace
}  // namespace rigidformer_ros::demo
