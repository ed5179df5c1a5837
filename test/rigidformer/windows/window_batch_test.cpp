// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/windows/window_batch.hpp"

#include <gtest/gtest.h>

#include <set>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/model/random_scene.hpp"
#include "window_scenes.hpp"

namespace rigidformer {
namespace {

const std::vector<Window> kWindows = {{2, 7, 5}, {0, 0, 10}, {1, 20, 1}};  // 3, 1 and 2 objects

class WindowBatchTest : public ::testing::Test {
 protected:
  void SetUp() override { torch::manual_seed(4); }

  WindowBatch make(const AugmentationOptions& options, int num_steps = 2) const {
    return make_window_batch(tensors_, kWindows, num_steps, 4, options);
  }

  const SceneArchive archive_ = flying_cubes_archive({1, 2, 3}, 60);
  const SceneTensors tensors_ = make_scene_tensors({archive_}, {4, 256, 1});
};

Tensor valid_points(const SceneBatch& scene, int64_t b, int64_t k) {
  return scene.points_reference[b][k].index({scene.point_mask[b][k]});
}

/// Which of the six faces of an axis-aligned cube of the given size points lie on.
std::set<int> faces(const Tensor& points, double size) {
  std::set<int> found;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      const Tensor on_face = (points.select(1, axis) - (side - 0.5) * size).abs() < 1e-6;
      if (on_face.any().item<bool>()) found.insert(2 * axis + side);
    }
  }
  return found;
}

TEST_F(WindowBatchTest, PosesMatchTheRecording) {
  const WindowBatch batch = make(no_augmentation(32));
  ASSERT_EQ(batch.poses.size(), 4u);
  for (int64_t b = 0; b < 3; ++b) {
    const Window& window = kWindows[static_cast<size_t>(b)];
    const SceneRecording& recording = archive_.scenes[static_cast<size_t>(window.scene)];
    for (int t = 0; t < 4; ++t) {
      for (size_t k = 0; k < recording.objects.size(); ++k) {
        const RigidTransform& T =
            recording.objects[k].T_world_object[static_cast<size_t>(window.frame + t * window.step_size)];
        const Pose& pose = batch.poses[static_cast<size_t>(t)];
        const auto row = static_cast<int64_t>(k);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_NEAR(pose.translation[b][row][axis].item<double>(), T.translation[axis], 1e-5);
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
  EXPECT_GT(count.item<int64_t>(), 16);   // more than the network looks at ...
  EXPECT_LT(count.item<int64_t>(), 256);  // ... and less than all sides
  const Tensor seen = scene.surface_points[0][2].index({scene.surface_mask[0][2]});
  const Tensor looked_at = valid_points(scene, 0, 2);
  EXPECT_LT(torch::cdist(looked_at, seen, 2.0, 2).amin(-1).max().item<double>(), 1e-6);  // noise and all
  EXPECT_FALSE(scene.surface_mask[1][2].any().item<bool>());                             // no such object
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
  for (int64_t k = 0; k < 3; ++k) {
    const Tensor points = valid_points(scene, 0, k);
    EXPECT_EQ(points.size(0), 32);
    EXPECT_LT(largest_difference(points.abs().amax(-1), torch::full({32}, 0.5 * (1.0 + static_cast<double>(k)))), 1e-5);
    EXPECT_EQ(std::get<0>(torch::_unique(scene.anchor_index[0][k])).size(0), 4);
  }
}

TEST_F(WindowBatchTest, NumberOfPointsStaysWithinBounds) {
  AugmentationOptions options = no_augmentation(40);
  options.min_points = 10;
  std::set<int64_t> counts;
  for (int i = 0; i < 10; ++i) {
    const SceneBatch scene = make(options).scene;
    EXPECT_EQ(scene.max_points(), 40);
    const Tensor count = scene.point_mask.sum(-1);
    for (int64_t b = 0; b < 3; ++b) {
      for (int64_t k = 0; k < 3; ++k) {
        if (!scene.object_mask[b][k].item<bool>()) continue;
        const auto n = count[b][k].item<int64_t>();
        counts.insert(n);
        ASSERT_TRUE(n >= 10 && n <= 40) << n;
        EXPECT_TRUE(scene.point_mask[b][k].slice(0, 0, n).all().item<bool>());  // valid ones first
        EXPECT_LT(scene.anchor_index[b][k].max().item<int64_t>(), n);
      }
    }
  }
  EXPECT_GT(counts.size(), 5u);
}

TEST_F(WindowBatchTest, VertexWindowsHoldTheMeshVertices) {
  AugmentationOptions options = no_augmentation(32);
  options.vertex_probability = 1.0;
  const SceneBatch scene = make(options).scene;
  const Tensor points = valid_points(scene, 0, 1);  // size 2
  EXPECT_EQ(points.size(0), 8);
  EXPECT_LT(largest_difference(points.abs(), torch::ones({8, 3})), 1e-6);
}

TEST_F(WindowBatchTest, YawKeepsRelativeGeometry) {
  AugmentationOptions options = no_augmentation(16);
  const WindowBatch plain = make(options);
  options.yaw_probability = 1.0;
  for (const bool per_batch : {true, false}) {
    options.yaw_per_batch = per_batch;
    const WindowBatch turned = make(options);
    Tensor yaw[4];
    for (size_t t = 0; t < 4; ++t) {
      const Pose &a = plain.poses[t], &b = turned.poses[t];
      yaw[t] = torch::matmul(b.rotation, a.rotation.transpose(-1, -2)).select(1, 0);  // [B, 3, 3]
      EXPECT_LT(largest_difference(yaw[t], yaw[0]), 1e-5);
      const Tensor all = yaw[t].unsqueeze(1);
      EXPECT_LT(largest_difference(torch::matmul(all, a.rotation), b.rotation), 1e-5);
      EXPECT_LT(largest_difference(torch::matmul(all, a.translation.unsqueeze(-1)).squeeze(-1), b.translation), 1e-4);
    }
    const Tensor up = torch::tensor({0.0F, 0.0F, 1.0F});
    EXPECT_LT(largest_difference(torch::matmul(yaw[0], up), up.expand({3, 3})), 1e-6);
    const Tensor angle =
        torch::atan2(yaw[0].select(1, 1).select(1, 0), yaw[0].select(1, 0).select(1, 0)) * 180.0 / M_PI;
    EXPECT_LT(largest_difference(angle / 5.0, (angle / 5.0).round()), 1e-3);
    EXPECT_EQ(largest_difference(angle, angle[0].expand({3})) < 1e-3, per_batch);
    EXPECT_GT(angle.abs().max().item<double>(), 1.0);
  }
}

TEST_F(WindowBatchTest, ShiftMovesWholeWindowsHorizontally) {
  AugmentationOptions options = no_augmentation(16);
  const WindowBatch plain = make(options);
  options.shift_m = 2.0;
  const WindowBatch moved = make(options);
  const Tensor shift = moved.poses[0].translation - plain.poses[0].translation;  // [B, K, 3]
  EXPECT_LT(largest_difference(shift, shift.slice(1, 0, 1).expand_as(shift)), 1e-5);
  EXPECT_EQ(shift.select(-1, 2).abs().max().item<double>(), 0.0);
  EXPECT_LE(shift.abs().max().item<double>(), 2.0);
  EXPECT_GT(largest_difference(shift[0], shift[1]), 0.01);
  EXPECT_LT(largest_difference(moved.poses[3].translation - plain.poses[3].translation, shift), 1e-5);
}

TEST_F(WindowBatchTest, ViewsShowOnlySidesThatFaceOneCamera) {
  AugmentationOptions options = no_augmentation(256);
  EXPECT_EQ(faces(valid_points(make(options).scene, 0, 2), 3.0).size(), 6u);
  options.view_probability = 1.0;
  std::set<std::set<int>> views;
  for (int i = 0; i < 10; ++i) {
    const SceneBatch scene = make(options).scene;
    for (int64_t k = 0; k < 3; ++k) {
      const std::set<int> seen = faces(valid_points(scene, 0, k), 1.0 + static_cast<double>(k));
      EXPECT_GE(seen.size(), 1u);
      for (int axis = 0; axis < 3; ++axis) EXPECT_LT(seen.count(2 * axis) + seen.count(2 * axis + 1), 2u);
      views.insert(seen);
    }
  }
  EXPECT_GT(views.size(), 2u);
  options.vertex_probability = 1.0;  // one side of a cube has seven corners: too few, so all eight stay
  EXPECT_EQ(valid_points(make(options).scene, 0, 0).size(0), 8);
}

TEST_F(WindowBatchTest, TheWholeSurfaceHasTheSidesThatNobodySees) {
  AugmentationOptions options = no_augmentation(64);
  options.view_probability = 1.0;
  options.noise_m = 0.01;
  const WindowBatch batch = make(options);
  const Tensor whole = batch.whole_surface[0][2].index({batch.whole_mask[0][2]});
  EXPECT_EQ(faces(whole, 3.0).size(), 6u);  // and no noise
  EXPECT_FALSE(batch.whole_mask[1][2].any().item<bool>()) << "no such object";
}

TEST_F(WindowBatchTest, NoStepsMeansTheTwoGivenPoses) {
  const WindowBatch batch = make(no_augmentation(16), 0);
  EXPECT_EQ(batch.poses.size(), 2u);
  EXPECT_TRUE(batch.departures.empty());
}

TEST_F(WindowBatchTest, P47_WhatTheRecordingDoesNotSayStaysUnknown) {
  SceneArchive archive = flying_cubes_archive({2}, 60);
  archive.scenes[0].objects[1].properties = {std::nullopt, 0.4, std::nullopt};
  const SceneTensors tensors = make_scene_tensors({archive}, {4, 64, 1});
  const SceneBatch scene = make_window_batch(tensors, {{0, 0, 5}}, 1, 4, no_augmentation(32)).scene;
  EXPECT_TRUE(torch::equal(scene.properties_known[0], torch::tensor({{1.0F, 1.0F, 1.0F}, {0.0F, 1.0F, 0.0F}})));
  EXPECT_GT(scene.properties[0][1][0].item<double>(), 0.0);  // a stand-in for networks that read no mask
}

TEST_F(WindowBatchTest, P41_StaticObjectsAreNotPredicted) {
  SceneArchive archive = flying_cubes_archive({2}, 60);
  archive.scenes[0].objects[1].is_static = true;
  const SceneTensors tensors = make_scene_tensors({archive}, {4, 64, 1});
  const SceneBatch scene = make_window_batch(tensors, {{0, 0, 5}}, 1, 4, no_augmentation(32)).scene;
  EXPECT_TRUE(torch::equal(scene.dynamic_mask, torch::tensor({{true, false}})));
}

TEST_F(WindowBatchTest, UnknownPropertiesAreMasked) {
  AugmentationOptions options = no_augmentation(16);
  options.unknown_probability = 1.0;
  const SceneBatch scene = make(options).scene;
  EXPECT_EQ(scene.properties_known.abs().sum().item<double>(), 0.0);
  EXPECT_EQ(scene.properties.abs().sum().item<double>(), 0.0);
}

TEST_F(WindowBatchTest, PermutationMovesObjectsWithEverythingTheyHave) {
  AugmentationOptions options = no_augmentation(64);
  options.permutation_probability = 1.0;
  std::set<std::vector<int>> orders;
  for (int i = 0; i < 20; ++i) {
    const WindowBatch batch = make(options);
    EXPECT_TRUE(torch::equal(batch.scene.object_mask.sum(-1), torch::tensor({3, 1, 2}, torch::kInt64)));
    std::vector<int> order;
    for (int64_t k = 0; k < 3; ++k) {
      const double size = 2.0 * valid_points(batch.scene, 0, k).abs().max().item<double>();
      order.push_back(static_cast<int>(std::lround(size)) - 1);
      const double start_x = 3.0 * order.back() + order.back() * 7 / 240.0;
      EXPECT_NEAR(batch.poses[0].translation[0][k][0].item<double>(), start_x, 1e-4);
    }
    orders.insert(order);
  }
  EXPECT_GT(orders.size(), 3u);
  for (const auto& order : orders) EXPECT_EQ(std::set<int>(order.begin(), order.end()), (std::set<int>{0, 1, 2}));
}

TEST_F(WindowBatchTest, NoiseIsSmallAndPresent) {
  AugmentationOptions options = no_augmentation(128);
  options.noise_m = 0.01;
  const Tensor radius = valid_points(make(options).scene, 0, 0).abs().amax(-1);
  const Tensor deviation = (radius - 0.5).abs();
  EXPECT_GT(deviation.max().item<double>(), 1e-5);
  EXPECT_LT(deviation.max().item<double>(), 0.06);
}

TEST_F(WindowBatchTest, SameSeedSameBatch) {
  AugmentationOptions options;
  options.view_probability = options.unknown_probability = 0.5;
  options.noise_m = 0.01;
  torch::manual_seed(9);
  const WindowBatch a = make(options);
  torch::manual_seed(9);
  const WindowBatch b = make(options);
  EXPECT_TRUE(torch::equal(a.scene.points_reference, b.scene.points_reference));
  EXPECT_TRUE(torch::equal(a.poses[3].rotation, b.poses[3].rotation));
  EXPECT_FALSE(torch::equal(make(options).scene.points_reference, a.scene.points_reference));
}

TEST_F(WindowBatchTest, AnchorsStartAtRandomPointsWhenAsked) {
  AugmentationOptions options = no_augmentation(64);
  options.vertex_probability = 1.0;  // the same points every time
  std::set<int64_t> fixed, random;
  for (int i = 0; i < 20; ++i) {
    fixed.insert(make(options).scene.anchor_index[0][0][0].item<int64_t>());
    random.insert(
        make_window_batch(tensors_, kWindows, 1, 4, options, true).scene.anchor_index[0][0][0].item<int64_t>());
  }
  EXPECT_EQ(fixed.size(), 1u);
  EXPECT_GT(random.size(), 3u);
}

}  // namespace
}  // namespace rigidformer
