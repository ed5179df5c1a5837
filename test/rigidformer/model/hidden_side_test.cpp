// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/hidden_side.hpp"

#include <gtest/gtest.h>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/model/random_scene.hpp"

namespace rigidformer {
namespace {

struct Clouds {
  Tensor points = torch::randn({2, 3, 20, 3}, torch::kFloat64);
  Tensor mask = torch::ones({2, 3, 20}, torch::kBool);
  Tensor centre = torch::randn({2, 3, 3}, torch::kFloat64);
};

HiddenSideHead head_with(double scale) {
  HiddenSideHead head;
  head->to(torch::kFloat64);
  torch::NoGradGuard no_grad;
  for (Tensor parameter : head->parameters()) parameter.add_(scale * torch::randn_like(parameter));
  return head;
}

class HiddenSideTest : public ::testing::Test {
 protected:
  HiddenSideTest() { torch::manual_seed(8); }
  const torch::NoGradGuard no_grad_;
};

TEST_F(HiddenSideTest, UntrainedItMirrorsThroughTheCentreOfMass) {
  const Clouds clouds;
  HiddenSideHead head;
  head->to(torch::kFloat64);
  const Tensor mirrored = 2.0 * clouds.centre.unsqueeze(2) - clouds.points;
  EXPECT_LT(largest_difference(head(clouds.points, clouds.mask, clouds.centre), mirrored), 1e-12);
}

TEST_F(HiddenSideTest, MovesAndGrowsWithTheCloud) {
  const Clouds clouds;
  HiddenSideHead head = head_with(0.1);
  const Tensor shift = torch::tensor({3.0, -1.0, 2.0}, torch::kFloat64);
  const Tensor guess = head(clouds.points, clouds.mask, clouds.centre);
  EXPECT_LT(largest_difference(head(clouds.points + shift, clouds.mask, clouds.centre + shift), guess + shift), 1e-9);
  EXPECT_LT(largest_difference(head(3.0 * clouds.points, clouds.mask, 3.0 * clouds.centre), 3.0 * guess), 1e-9);
}

TEST_F(HiddenSideTest, OrderOfPointsAndPaddingDoNotMatter) {
  Clouds clouds;
  HiddenSideHead head = head_with(0.1);
  const Tensor guess = head(clouds.points, clouds.mask, clouds.centre);
  const Tensor order = torch::randperm(20, torch::kInt64);
  const Tensor shuffled = head(clouds.points.index_select(2, order), clouds.mask, clouds.centre);
  EXPECT_LT(largest_difference(shuffled, guess.index_select(2, order)), 1e-12);
  const Tensor padded_points = torch::cat({clouds.points, 9.0 * torch::ones({2, 3, 4, 3}, torch::kFloat64)}, 2);
  const Tensor padded_mask = torch::cat({clouds.mask, torch::zeros({2, 3, 4}, torch::kBool)}, 2);
  EXPECT_LT(largest_difference(head(padded_points, padded_mask, clouds.centre).slice(2, 0, 20), guess), 1e-12);
}

TEST_F(HiddenSideTest, TheModelGuessesInTheReferenceFrame) {
  RandomScene scene = random_scene(3, {{12, 9}});
  ModelOptions options = contact_aware(model_preset("tiny"));
  options.engine_motion = options.hidden_side_head = true;
  RigidFormer model = random_model(options);
  const Tensor centre = model->centre_of_mass(scene.batch, scene.state.current);
  const Tensor guess = model->hidden_side(scene.batch, scene.state.current, centre);
  ASSERT_EQ(guess.sizes(), scene.batch.points_reference.sizes());
  const Tensor world =
      model->hidden_side_head(scene.state.current.apply(scene.batch.points_reference), scene.batch.point_mask,
                              scene.state.current.apply(centre.unsqueeze(2)).squeeze(2));
  EXPECT_LT(largest_difference(scene.state.current.apply(guess), world), 1e-9);
  EXPECT_FALSE(random_model(model_preset("tiny"))->hidden_side(scene.batch, scene.state.current, centre).defined());
}

TEST_F(HiddenSideTest, OnlyModelsThatAskForHullsHaveTheHead) {
  ModelOptions options = contact_aware(model_preset("tiny"));
  options.hidden_side_head = true;
  EXPECT_NE(error_of([&] { validate(options); }).find("hidden_side_head"), std::string::npos);
  options.contact_tokens = true;
  EXPECT_EQ(error_of([&] { validate(options); }), "");
}

}  // namespace
}  // namespace rigidformer
