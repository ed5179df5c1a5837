// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <set>
#include <vector>

#include "rigidformer/model/scene_input.hpp"
#include "window_batch_fixture.hpp"

namespace rigidformer {
namespace {

TEST_F(WindowBatchTest, NumberOfPointsStaysWithinBounds) {
  AugmentationOptions options = no_augmentation(40);
  options.min_points = 10;
  std::set<std::int64_t> counts;
  for (int i = 0; i < 10; ++i) {
    const SceneBatch scene = make(options).scene;
    EXPECT_LE(scene.max_points(), 40);
    const Tensor count = scene.point_mask.sum(-1);
    for (std::int64_t b = 0; b < 3; ++b) {
      for (std::int64_t k = 0; k < 3; ++k) {
        if (!scene.object_mask[b][k].item<bool>()) continue;
        const auto n = count[b][k].item<std::int64_t>();
        counts.insert(n);
        ASSERT_TRUE(n >= 10 && n <= 40) << n;
        EXPECT_TRUE(scene.point_mask[b][k].slice(0, 0, n).all().item<bool>());  // the valid points come first
        EXPECT_LT(scene.anchor_index[b][k].max().item<std::int64_t>(), n);
      }
    }
  }
  EXPECT_GT(counts.size(), 5u);
}

TEST_F(WindowBatchTest, NumberOfPointsIsDrawnFromAList) {
  AugmentationOptions options = no_augmentation(64);
  options.point_counts = {8, 32, 64};
  std::set<std::int64_t> counts;
  for (int i = 0; i < 10; ++i) {
    const SceneBatch scene = make(options).scene;
    const Tensor count = scene.point_mask.sum(-1).masked_select(scene.object_mask);
    for (std::int64_t j = 0; j < count.numel(); ++j) counts.insert(count[j].item<std::int64_t>());
  }
  EXPECT_EQ(counts, (std::set<std::int64_t>{8, 32, 64}));
}

TEST_F(WindowBatchTest, MasksDropAShareOfThePoints) {
  AugmentationOptions options = no_augmentation(256);
  options.mask_probability = 1.0;
  options.masked_share = 0.25;
  int boxes = 0;
  for (int i = 0; i < 20; ++i) {
    const WindowBatch batch = make(options);
    const Tensor kept = valid_points(batch.scene, 0, 1);
    ASSERT_EQ(kept.size(0), 192);
    const Tensor whole = batch.whole_surface[0][1].index({batch.whole_mask[0][1]});
    ASSERT_EQ(whole.size(0), 256);
    // In a box: some dropped point whose nearest dropped ones make up the whole, so that a large ball is empty.
    const Tensor to_kept = (whole.unsqueeze(1) - kept.unsqueeze(0)).norm(2, -1).amin(-1);
    if (to_kept.max().item<double>() > 0.5) ++boxes;  // the cube has edges of 2 m, 256 points lie 0.3 m apart
  }
  EXPECT_GT(boxes, 3);
  EXPECT_LT(boxes, 17);
  options.vertex_probability = 1.0;  // of the eight corners of a cube none may go
  EXPECT_EQ(valid_points(make(options).scene, 0, 1).size(0), 8);
}

TEST_F(WindowBatchTest, ScenesAreCentredAsAtPrediction) {
  const WindowBatch batch = make(no_augmentation(64));
  for (std::int64_t b = 0; b < 3; ++b) {
    const auto K = batch.scene.object_mask[b].sum().item<std::int64_t>();
    std::vector<ObjectState> objects;
    for (std::int64_t k = 0; k < K; ++k) {
      const Tensor cloud = valid_points(batch.scene, b, k).contiguous();
      ObjectState object;
      object.points_reference = Eigen::Map<const Points>(cloud.data_ptr<float>(), cloud.size(0), 3);
      const Tensor R = batch.poses[1].rotation[b][k].contiguous(), t = batch.poses[1].translation[b][k].contiguous();
      using RowMatrix = Eigen::Matrix<float, 3, 3, Eigen::RowMajor>;
      object.T_world_current = {
          Eigen::Quaterniond(Eigen::Matrix3d(Eigen::Map<const RowMatrix>(R.data_ptr<float>()).cast<double>())),
          Eigen::Map<const Eigen::Vector3f>(t.data_ptr<float>()).cast<double>()};
      object.T_world_previous = object.T_world_current;
      objects.push_back(object);
    }
    RolloutOptions rollout;
    rollout.ground_height_m = 0.0;
    const SceneInput input = make_scene_input(objects, rollout, model_preset("tiny"), 64);
    EXPECT_LT(input.origin_world.norm(), 1e-4) << "the windows stand where prediction moves them";
  }
}

TEST_F(WindowBatchTest, VertexWindowsHoldTheMeshVertices) {
  AugmentationOptions options = no_augmentation(32);
  options.vertex_probability = 1.0;
  const SceneBatch scene = make(options).scene;
  const Tensor points = valid_points(scene, 0, 1);  // the cube of size 2
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
      const Tensor from_first = a.translation - plain.poses[0].translation.slice(1, 0, 1);
      EXPECT_LT(largest_difference(torch::matmul(all, from_first.unsqueeze(-1)).squeeze(-1),
                                   b.translation - turned.poses[0].translation.slice(1, 0, 1)),
                1e-4);
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
    for (std::int64_t k = 0; k < 3; ++k) {
      const std::set<int> seen = faces(valid_points(scene, 0, k), 1.0 + static_cast<double>(k));
      EXPECT_GE(seen.size(), 1u);
      for (int axis = 0; axis < 3; ++axis) EXPECT_LT(seen.count(2 * axis) + seen.count(2 * axis + 1), 2u);
      views.insert(seen);
    }
  }
  EXPECT_GT(views.size(), 2u);
  options.vertex_probability = 1.0;  // one side of a cube has seven corners: too few, so that all eight stay
  EXPECT_EQ(valid_points(make(options).scene, 0, 0).size(0), 8);
}

TEST_F(WindowBatchTest, TheWholeSurfaceHasTheSidesThatNobodySees) {
  AugmentationOptions options = no_augmentation(64);
  options.view_probability = 1.0;
  options.noise_m = 0.01;
  const WindowBatch batch = make(options);
  const Tensor whole = batch.whole_surface[0][2].index({batch.whole_mask[0][2]});
  EXPECT_EQ(faces(whole, 3.0).size(), 6u);  // without noise
  EXPECT_FALSE(batch.whole_mask[1][2].any().item<bool>()) << "no such object";
}

TEST_F(WindowBatchTest, UnknownPropertiesAreMasked) {
  AugmentationOptions options = no_augmentation(16);
  options.unknown_probability = 1.0;
  const SceneBatch scene = make(options).scene;
  EXPECT_EQ(scene.properties_known.abs().sum().item<double>(), 0.0);
  EXPECT_EQ(scene.properties.abs().sum().item<double>(), 0.0);
}

TEST_F(WindowBatchTest, TheGroundIsToldUnlessItIsHidden) {
  SceneArchive archive = archive_;
  archive.scenes[2].ground = {0.9, std::nullopt};
  const SceneTensors tensors = make_scene_tensors({archive}, {4, 256, 1});
  AugmentationOptions options = no_augmentation(16);
  const SceneBatch told = make_window_batch(tensors, kWindows, 1, 4, options).scene;
  EXPECT_TRUE(torch::allclose(told.ground_material, torch::tensor({{0.9, 0.0}, {0.3, 0.5}, {0.3, 0.5}})));
  EXPECT_TRUE(torch::equal(told.ground_known, torch::tensor({{1.0, 0.0}, {1.0, 1.0}, {1.0, 1.0}})));
  options.unknown_probability = 0.5;
  std::set<std::pair<bool, bool>> kinds;  // whether objects and ground are known
  for (int i = 0; i < 30; ++i) {
    const SceneBatch scene = make_window_batch(tensors, kWindows, 1, 4, options).scene;
    EXPECT_TRUE(torch::equal(scene.ground_material, told.ground_material * scene.ground_known));
    kinds.emplace(scene.properties_known[1].any().item<bool>(), scene.ground_known[1].any().item<bool>());
  }
  EXPECT_EQ(kinds.size(), 4u);
}

TEST_F(WindowBatchTest, PermutationMovesObjectsWithEverythingTheyHave) {
  AugmentationOptions options = no_augmentation(64);
  options.permutation_probability = 1.0;
  std::set<std::vector<int>> orders;
  for (int i = 0; i < 20; ++i) {
    const WindowBatch batch = make(options);
    EXPECT_TRUE(torch::equal(batch.scene.object_mask.sum(-1), torch::tensor({3, 1, 2}, torch::kInt64)));
    std::vector<int> order;
    for (std::int64_t k = 0; k < 3; ++k) {
      const double size = 2.0 * valid_points(batch.scene, 0, k).abs().max().item<double>();
      order.push_back(static_cast<int>(std::lround(size)) - 1);
      const double apart_m = (order.back() - order.front()) * (3.0 + 7 / 240.0);
      const Tensor x = batch.poses[0].translation[0].select(-1, 0);
      EXPECT_NEAR((x[k] - x[0]).item<double>(), apart_m, 1e-4);
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
  std::set<std::int64_t> fixed, random;
  for (int i = 0; i < 20; ++i) {
    fixed.insert(make(options).scene.anchor_index[0][0][0].item<std::int64_t>());
    random.insert(
        make_window_batch(tensors_, kWindows, 1, 4, options, true).scene.anchor_index[0][0][0].item<std::int64_t>());
  }
  EXPECT_EQ(fixed.size(), 1u);
  EXPECT_GT(random.size(), 3u);
}

}  // namespace
}  // namespace rigidformer
