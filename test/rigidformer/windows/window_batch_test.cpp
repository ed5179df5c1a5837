// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/window_batch.hpp"

#include <cmath>
#include <optional>

#include "rigidformer/model/scene_input.hpp"
#include "window_batch_fixture.hpp"

namespace rigidformer {
namespace {

TEST_F(WindowBatchTest, PosesMatchTheRecordingButForAHorizontalShift) {
  const WindowBatch batch = make(no_augmentation(32));
  ASSERT_EQ(batch.poses.size(), 4u);
  for (std::int64_t b = 0; b < 3; ++b) {
    const Window& window = kWindows[static_cast<size_t>(b)];
    const SceneRecording& recording = archive_.scenes[static_cast<size_t>(window.scene)];
    const Tensor first = batch.poses[0].translation[b][0];
    Eigen::Vector3d shift(first[0].item<double>(), first[1].item<double>(), 0.0);
    shift.head<2>() -= recording.objects[0].T_world_object[static_cast<size_t>(window.frame)].translation.head<2>();
    for (int t = 0; t < 4; ++t) {
      for (size_t k = 0; k < recording.objects.size(); ++k) {
        const RigidTransform& T =
            recording.objects[k].T_world_object[static_cast<size_t>(window.frame + t * window.step_size)];
        const Pose& pose = batch.poses[static_cast<size_t>(t)];
        const auto row = static_cast<std::int64_t>(k);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_NEAR(pose.translation[b][row][axis].item<double>(), T.translation[axis] + shift[axis], 1e-5);
          for (int other = 0; other < 3; ++other) {
            EXPECT_NEAR(pose.rotation[b][row][axis][other].item<double>(), T.rotation.toRotationMatrix()(axis, other),
                        1e-6);
          }
        }
      }
    }
  }
}

TEST_F(WindowBatchTest, DeparturesAreTheFramesBeforeForStepsOfOneFrame) {
  AugmentationOptions options = no_augmentation(32);
  options.yaw_probability = 1.0;
  options.shift_m = 1.0;
  const WindowBatch batch = make(options, 3);
  ASSERT_EQ(batch.departures.size(), 3u);
  for (size_t step = 0; step < 3; ++step) {  // window 2 has s = 1 and two objects
    const Pose &departure = batch.departures[step], &before = batch.poses[step + 1];
    EXPECT_LT(largest_difference(departure.translation[2].slice(0, 0, 2), before.translation[2].slice(0, 0, 2)), 1e-5);
    EXPECT_LT(largest_difference(departure.rotation[2].slice(0, 0, 2), before.rotation[2].slice(0, 0, 2)), 1e-5);
  }
}

TEST_F(WindowBatchTest, TheSurfaceHoldsAllThatIsSeen) {
  AugmentationOptions options = no_augmentation(16);
  options.noise_m = 0.01;
  options.view_probability = 1.0;
  const SceneBatch scene = make(options).scene;
  const Tensor count = scene.surface_mask[0][2].sum();
  EXPECT_GT(count.item<std::int64_t>(), 16);   // more than the network looks at ...
  EXPECT_LT(count.item<std::int64_t>(), 256);  // ... and less than all sides
  const Tensor seen = scene.surface_points[0][2].index({scene.surface_mask[0][2]});
  const Tensor looked_at = valid_points(scene, 0, 2);
  EXPECT_LT(torch::cdist(looked_at, seen, 2.0, 2).amin(-1).max().item<double>(), 1e-6);  // with the same noise
  EXPECT_FALSE(scene.surface_mask[1][2].any().item<bool>());                             // there is no such object
}

TEST_F(WindowBatchTest, SceneHoldsWhatWasRecorded) {
  const SceneBatch scene = make(no_augmentation(32)).scene;
  const Tensor count = scene.object_mask.sum(-1);
  EXPECT_TRUE(torch::equal(count, torch::tensor({3, 1, 2}, torch::kInt64)));
  EXPECT_TRUE(torch::equal(scene.dynamic_mask, scene.object_mask));
  EXPECT_TRUE(torch::equal(scene.step_size, torch::tensor({5.0F, 10.0F, 1.0F})));
  EXPECT_TRUE(torch::equal(scene.gravity, torch::full({3}, -10.0F)));
  EXPECT_TRUE(torch::equal(scene.ground_height, torch::zeros({3})));
  EXPECT_TRUE(torch::equal(scene.properties[0][2], torch::tensor({2.0F, 0.4F, 0.6F})));
  EXPECT_TRUE(torch::equal(scene.properties_known[0], torch::ones({3, 3})));
  EXPECT_TRUE(torch::equal(scene.point_mask.any(-1), scene.object_mask));
  for (std::int64_t k = 0; k < 3; ++k) {
    const Tensor points = valid_points(scene, 0, k);
    EXPECT_EQ(points.size(0), 32);
    EXPECT_LT(largest_difference(points.abs().amax(-1), torch::full({32}, 0.5 * (1.0 + static_cast<double>(k)))), 1e-5);
    EXPECT_EQ(std::get<0>(torch::_unique(scene.anchor_index[0][k])).size(0), 4);
  }
}

TEST_F(WindowBatchTest, NormalsAreWhatAPredictorMakesOfTheSamePoints) {
  AugmentationOptions options = no_augmentation(256);  // all points of the sets
  const SceneBatch scene = make(options).scene;
  ModelOptions model = contact_aware(model_preset("tiny"));
  for (std::int64_t k = 0; k < 3; ++k) {
    const Tensor points = valid_points(scene, 0, k).contiguous();
    ObjectState object;
    object.points_reference = Eigen::Map<const Points>(points.data_ptr<float>(), points.size(0), 3);
    const SceneBatch seen = make_scene_input({object}, {}, model, 256).batch;
    const Tensor normals = scene.normals_reference[0][k].index({scene.point_mask[0][k]});
    EXPECT_LT(largest_difference(seen.normals_reference[0][0].index({seen.point_mask[0][0]}), normals), 1e-3);
    EXPECT_LT(largest_difference(normals.norm(2, -1), torch::ones({points.size(0)})), 1e-5);
  }
  options.vertex_probability = 1.0;
  const SceneBatch corners = make(options).scene;
  const Tensor diagonals = valid_points(corners, 0, 0) / (0.5 * std::sqrt(3.0));
  EXPECT_LT(largest_difference(corners.normals_reference[0][0].slice(0, 0, 8), diagonals), 1e-3);
}

TEST_F(WindowBatchTest, NoStepsMeansTheTwoGivenPoses) {
  const WindowBatch batch = make(no_augmentation(16), 0);
  EXPECT_EQ(batch.poses.size(), 2u);
  EXPECT_TRUE(batch.departures.empty());
}

TEST_F(WindowBatchTest, P46_TheNetworkIsToldHowLongAStepReallyIs) {
  SceneArchive archive = flying_cubes_archive({1, 1}, 60);
  archive.scenes[1].frame_rate_hz = 60.0;  // the same poses, four times as slow
  const SceneTensors tensors = make_scene_tensors({archive}, {4, 64, 1});
  const WindowBatch batch = make_window_batch(tensors, {{0, 0, 8}, {1, 0, 2}}, 1, 4, no_augmentation(32));
  EXPECT_TRUE(torch::equal(batch.scene.step_size, torch::tensor({8.0F, 8.0F})));
  const Tensor rise = (batch.poses[1].translation - batch.poses[0].translation).select(-1, 2);
  const Tensor departed = (batch.poses[2].translation - batch.departures[0].translation).select(-1, 2);
  EXPECT_GT(rise[0][0].item<double>(), 3.0 * rise[1][0].item<double>());
  EXPECT_GT(departed[0][0].item<double>(), 3.0 * departed[1][0].item<double>());
}

TEST_F(WindowBatchTest, P47_WhatTheRecordingDoesNotSayStaysUnknown) {
  SceneArchive archive = flying_cubes_archive({2}, 60);
  archive.scenes[0].objects[1].properties = {std::nullopt, 0.4, std::nullopt};
  const SceneTensors tensors = make_scene_tensors({archive}, {4, 64, 1});
  const SceneBatch scene = make_window_batch(tensors, {{0, 0, 5}}, 1, 4, no_augmentation(32)).scene;
  EXPECT_TRUE(torch::equal(scene.properties_known[0], torch::tensor({{1.0F, 1.0F, 1.0F}, {0.0F, 1.0F, 0.0F}})));
  EXPECT_GT(scene.properties[0][1][0].item<double>(), 0.0);  // a stand-in for networks that read no mask
}

TEST_F(WindowBatchTest, P41_StaticAndDrivenObjectsAreNotPredicted) {
  SceneArchive archive = flying_cubes_archive({3}, 60);
  archive.scenes[0].objects[1].is_static = true;
  archive.scenes[0].objects[2].is_driven = true;
  const SceneTensors tensors = make_scene_tensors({archive}, {4, 64, 1});
  const SceneBatch scene = make_window_batch(tensors, {{0, 0, 5}}, 1, 4, no_augmentation(32)).scene;
  EXPECT_TRUE(torch::equal(scene.dynamic_mask, torch::tensor({{true, false, false}})));
}

}  // namespace
}  // namespace rigidformer
