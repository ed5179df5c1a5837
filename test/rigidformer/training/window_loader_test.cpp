// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/window_loader.hpp"

#include <gtest/gtest.h>

#include "rigidformer/model/random_scene.hpp"
#include "rigidformer/windows/window_scenes.hpp"

namespace rigidformer {
namespace {

TEST(WindowLoader, AWindowDoesNotDependOnWhenItIsAssembled) {
  TrainingData data;
  data.training = make_scene_tensors({flying_cubes_archive({1, 2, 3}, 60)}, {4, 64, 1});
  data.sampler = std::make_shared<WindowSampler>(WindowOptions{}, ContactEvents{}, data.training.object_counts(),
                                                 data.training.frame_counts());
  TrainingOptions options;
  options.batch_size = 4;
  options.augmentation.max_points = 32;
  options.augmentation.min_points = 16;
  options.augmentation.noise_m = 0.01;
  options.augmentation.permutation_probability = 0.0;
  options.model.random_anchors = true;
  WindowLoader ahead(data, options);
  ahead.take({0, 2}, {1, 2});
  torch::manual_seed(99);  // others draw random numbers meanwhile
  torch::rand({7});
  const WindowBatch second = ahead.take({1, 2}, {2, 2});
  const WindowBatch alone = WindowLoader(data, options).take({1, 2}, {5, 1});
  EXPECT_TRUE(torch::equal(second.scene.points_reference, alone.scene.points_reference));
  EXPECT_TRUE(torch::equal(second.scene.anchor_index, alone.scene.anchor_index));
  EXPECT_TRUE(torch::equal(second.poses[3].translation, alone.poses[3].translation));
  const WindowBatch third = ahead.take({3, 1}, {4, 1});  // another window than the one that was begun
  EXPECT_EQ(third.poses.size(), 3u);
  EXPECT_TRUE(torch::equal(WindowLoader(data, options).take({3, 1}, {4, 1}).scene.points_reference,
                           third.scene.points_reference));
  EXPECT_FALSE(torch::equal(third.scene.points_reference, second.scene.points_reference));
}

}  // namespace
}  // namespace rigidformer
