// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/camera/camera_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace rigidformer_ros::camera {
namespace {

CameraOptions small_options() {
  CameraOptions options;
  options.scene_set = "movi_a";
  options.duration = 0.5;
  options.width = 96;
  options.height = 72;
  return options;
}

TEST(CameraScene, LabelledPointsLieOnTheirObjects) {
  CameraOptions options = small_options();
  options.mislabelled = options.depth_noise = options.pixel_noise = 0.0;
  const CameraScene scene(options, 0);
  ASSERT_EQ(scene.num_frames(), 16);
  const CameraView view = scene.view(10);
  int on_objects = 0;
  for (std::size_t i = 0; i < view.frame.body.size(); ++i) {
    const int object = view.frame.body[i];
    if (object == rigidformer::DepthImage::kBackground) {
      continue;
    }
    ++on_objects;
    const Eigen::Vector3d camera =
        view.frame.points_camera.row(static_cast<Eigen::Index>(i)).transpose().cast<double>();
    const Eigen::Vector3d world = scene.T_world_camera() * camera;
    const Eigen::Vector3d centre = scene.T_world_object(object, scene.time_s(10)).translation;
    const double radius = scene.surface_points(object).rowwise().norm().maxCoeff();
    EXPECT_LT((world - centre).norm(), 1.2 * radius);
  }
  EXPECT_GT(on_objects, 50);
}

TEST(CameraScene, VisibleFractionsAreBelowHalf) {
  const CameraScene scene(small_options(), 0);
  const CameraView view = scene.view(0);
  double largest = 0.0;
  for (int object = 0; object < scene.num_objects(); ++object) {
    const double fraction = scene.visible_fraction(view, object);
    EXPECT_LE(fraction, 0.56);
    largest = std::max(largest, fraction);
  }
  EXPECT_GT(largest, 0.3);
}

TEST(CameraScene, ATabletopSceneIsTheSameSceneSmallerAndFaster) {
  CameraOptions options = small_options();
  const CameraScene large(options, 2);
  options.scale = 0.07;
  const CameraScene small(options, 2);
  ASSERT_EQ(small.num_objects(), large.num_objects());
  const double t = 0.1;
  for (int object = 0; object < large.num_objects(); ++object) {
    const auto expected = large.T_world_object(object, t);
    const auto actual = small.T_world_object(object, std::sqrt(0.07) * t);
    EXPECT_LT((actual.translation - 0.07 * expected.translation).norm(), 1e-9);
    EXPECT_LT(rigidformer::rotation_angle(actual.rotation, expected.rotation), 1e-6);
    EXPECT_TRUE(small.surface_points(object).isApprox(0.07F * large.surface_points(object), 1e-5F));
  }
  // The image without noise must be the same, because camera and scene shrink together.
  EXPECT_EQ(small.view(0).image.body, large.view(0).image.body);
}

TEST(CameraScene, TheSameNumberIsTheSameScene) {
  const CameraScene scene(small_options(), 0);
  const CameraScene again(small_options(), 0);
  const CameraScene other(small_options(), 1);
  EXPECT_EQ(again.view(3).frame.points_camera, scene.view(3).frame.points_camera);
  EXPECT_NE(other.T_world_object(0, 0.0).translation, scene.T_world_object(0, 0.0).translation);
}

TEST(CameraScene, InvalidOptionsAreNamed) {
  const std::pair<const char*, std::function<void(CameraOptions&)>> cases[] = {
      {"nowhere", [](CameraOptions& o) { o.scene_set = "nowhere"; }},
      {"nowhere", [](CameraOptions& o) { o.scene_file = "/nowhere.safetensors"; }},
      {"duration", [](CameraOptions& o) { o.duration = 0.0; }},
      {"frame_rate", [](CameraOptions& o) { o.frame_rate = -30.0; }},
      {"scale", [](CameraOptions& o) { o.scale = 0.0; }},
      {"position",
       [](CameraOptions& o) {
         o.position = {1.0, 2.0};
       }},
      {"straight above",
       [](CameraOptions& o) {
         o.position = {0.0, 0.0, 5.0};
       }},
      {"camera_frame", [](CameraOptions& o) { o.camera_frame = o.fixed_frame; }},
      {"dropout", [](CameraOptions& o) { o.dropout = 2.0; }}};
  for (const auto& [part, damage] : cases) {
    CameraOptions options = small_options();
    damage(options);
    try {
      const CameraScene scene(options, 0);
      ADD_FAILURE() << part << " was accepted";
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace rigidformer_ros::camera
