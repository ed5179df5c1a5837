// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/scene_tensors.hpp"

#include <gtest/gtest.h>

#include <string>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/model/random_scene.hpp"
#include "window_scenes.hpp"

namespace rigidformer {
namespace {

TEST(SceneTensorsTest, ShapesAndSetsAreAsAsked) {
  SceneArchive example = example_archive(20);
  for (SceneRecording& scene : example.scenes) scene.frame_rate_hz = 240.0;
  const SceneTensors tensors = make_scene_tensors({flying_cubes_archive({1, 3}, 20), example}, {3, 50, 1});
  EXPECT_EQ(tensors.num_scenes(), 4);
  EXPECT_EQ(tensors.num_frames(), 20);
  EXPECT_EQ(tensors.max_objects(), 3);
  EXPECT_EQ(tensors.object_counts(), (std::vector<std::int64_t>{1, 3, 1, 2}));
  EXPECT_EQ(tensors.shape_points.sizes(), (std::vector<std::int64_t>{2, 3, 50, 3}));
  EXPECT_TRUE(torch::equal(tensors.shape_point_count, torch::tensor({{8, 50, 50}, {4, 50, 50}}, torch::kInt64)));
  EXPECT_EQ(tensors.shape[2][0].item<std::int64_t>(), 1);  // the second archive has its own shapes
  EXPECT_NEAR(tensors.gravity[3].item<double>(), -9.0, 1e-6);
  EXPECT_FALSE(torch::equal(tensors.shape_points[0][1], tensors.shape_points[0][2]));
  const Tensor corner_normals = tensors.shape_normals[0][0].slice(0, 0, 8), corners = tensors.shape_points[0][0];
  EXPECT_LT(largest_difference(corner_normals.sign(), corners.slice(0, 0, 8).sign()), 1e-6) << "outwards";
  EXPECT_LT(largest_difference(tensors.shape_normals.slice(1, 1).norm(2, -1), torch::ones({2, 2, 50})), 1e-5);
}

TEST(SceneTensorsTest, RefusesNoScenes) { EXPECT_THROW(make_scene_tensors({}, {}), std::invalid_argument); }

TEST(SceneTensorsTest, P46_EverySceneKeepsItsFrameRate) {
  SceneArchive archive = flying_cubes_archive({1, 1}, 30);
  archive.scenes[1].frame_rate_hz = 53.5;
  EXPECT_EQ(make_scene_tensors({archive}, {2, 16, 1}).frame_rates(), (std::vector<double>{240.0, 53.5}));
  EXPECT_EQ(frames_at_rate(10, 240.0), 10);
  EXPECT_EQ(frames_at_rate(10, 239.9), 10);
  EXPECT_EQ(frames_at_rate(10, 53.5), 2);
  EXPECT_EQ(frames_at_rate(1, 53.5), 1);
  EXPECT_EQ(frames_at_rate(10, 480.0), 20);
}

TEST(SceneTensorsTest, P45_ShortScenesArePaddedWithTheirLastPose) {
  SceneArchive archive = flying_cubes_archive({1, 1}, 30);
  archive.scenes[0] = flying_cubes(1, 25);
  const SceneTensors tensors = make_scene_tensors({archive}, {2, 16, 1});
  EXPECT_EQ(tensors.frame_counts(), (std::vector<std::int64_t>{25, 30}));
  EXPECT_TRUE(torch::equal(tensors.poses[0][29], tensors.poses[0][24]));
}

}  // namespace
}  // namespace rigidformer
