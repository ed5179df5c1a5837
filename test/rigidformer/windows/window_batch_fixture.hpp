// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/model/random_scene.hpp"
#include "rigidformer/windows/window_batch.hpp"
#include "window_scenes.hpp"

namespace rigidformer {

inline const std::vector<Window> kWindows = {{2, 7, 5}, {0, 0, 10}, {1, 20, 1}};  // scenes of 3, 1 and 2 objects

class WindowBatchTest : public ::testing::Test {
 protected:
  void SetUp() override { torch::manual_seed(4); }

  WindowBatch make(const AugmentationOptions& options, int num_steps = 2) const {
    return make_window_batch(tensors_, kWindows, num_steps, 4, options);
  }

  const SceneArchive archive_ = flying_cubes_archive({1, 2, 3}, 60);
  const SceneTensors tensors_ = make_scene_tensors({archive_}, {4, 256, 1});
};

inline Tensor valid_points(const SceneBatch& scene, std::int64_t b, std::int64_t k) {
  return scene.points_reference[b][k].index({scene.point_mask[b][k]});
}

/// The faces of an axis-aligned cube of the given size, out of six, on which points lie.
inline std::set<int> faces(const Tensor& points, double size) {
  std::set<int> found;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      const Tensor on_face = (points.select(1, axis) - (side - 0.5) * size).abs() < 1e-6;
      if (on_face.any().item<bool>()) found.insert(2 * axis + side);
    }
  }
  return found;
}

}  // namespace rigidformer
