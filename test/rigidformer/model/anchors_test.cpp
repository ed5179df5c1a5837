// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/anchors.hpp"

#include <gtest/gtest.h>

#include <set>

#include "random_scene.hpp"
#include "rigidformer/geometry/farthest_point_sampling.hpp"

namespace rigidformer {
namespace {

class FarthestAnchorsTest : public ::testing::Test {
 protected:
  const RandomScene scene_ = random_scene(3, {{30, 12}, {25, 6}});
  const Tensor points_ = scene_.batch.points_reference;
  const Tensor mask_ = scene_.batch.point_mask;
};

TEST_F(FarthestAnchorsTest, EqualFarthestPointSamplingOfTheValidPoints) {
  const Tensor anchors = farthest_anchors(points_, mask_, 5);
  for (std::int64_t b = 0; b < 2; ++b) {
    for (std::int64_t k = 0; k < 2; ++k) {
      const Tensor cloud = points_[b][k].index({mask_[b][k]}).to(torch::kFloat32).contiguous();
      const Points rows = Eigen::Map<const Points>(cloud.data_ptr<float>(), cloud.size(0), 3);
      const std::vector<int> expected = farthest_point_order(rows, 5);
      for (size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(anchors[b][k][static_cast<std::int64_t>(i)].item<std::int64_t>(), expected[i]);
      }
    }
  }
}

TEST_F(FarthestAnchorsTest, DoNotDependOnVertexOrder) {
  const Tensor anchors = farthest_anchors(points_, mask_, 5);
  const Tensor order = torch::rand(mask_.sizes()).argsort();
  const Tensor shuffled = gather_points(points_, order);
  const Tensor again = farthest_anchors(shuffled, mask_.gather(-1, order), 5);
  EXPECT_FALSE(torch::equal(again, anchors));
  EXPECT_TRUE(torch::equal(gather_points(shuffled, again), gather_points(points_, anchors)));
}

TEST_F(FarthestAnchorsTest, RandomStartsAreValidDistinctAndDifferent) {
  std::set<std::int64_t> starts;
  for (int i = 0; i < 30; ++i) {
    const Tensor anchors = farthest_anchors(points_, mask_, 4, torch::rand(mask_.sizes()));
    EXPECT_TRUE(mask_.gather(-1, anchors).all().item<bool>());
    starts.insert(anchors[0][0][0].item<std::int64_t>());
    for (std::int64_t b = 0; b < 2; ++b) {
      for (std::int64_t k = 0; k < 2; ++k) EXPECT_EQ(std::get<0>(torch::_unique(anchors[b][k])).size(0), 4);
    }
  }
  EXPECT_GT(starts.size(), 5u);
}

}  // namespace
}  // namespace rigidformer
