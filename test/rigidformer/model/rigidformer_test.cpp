// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/rigidformer.hpp"

#include <gtest/gtest.h>

#include "random_scene.hpp"

namespace rigidformer {
namespace {

constexpr double kSameToRounding = 1e-9;  // float64, with another order of summation
constexpr double kVisible = 1e-4;         // a difference that a broken property would show
const std::vector<std::vector<std::int64_t>> kMixedScenes = {{20, 9, 16},
                                                             {12, 17}};  // points of each object in two scenes

RandomScene reordered_objects(RandomScene scene, const Tensor& order) {
  for_each_object_tensor(scene, [&](Tensor& tensor) { tensor = tensor.index_select(1, order); });
  return scene;
}

/// Puts the same points in another order; anchors stay the same points.
RandomScene reordered_points(RandomScene scene) {
  SceneBatch& b = scene.batch;
  const Tensor order = (torch::rand(b.point_mask.sizes()) + b.point_mask.logical_not()).argsort();  // valid first
  b.points_reference = gather_points(b.points_reference, order);
  b.normals_reference = gather_points(b.normals_reference, order);
  b.anchor_index = order.argsort().gather(-1, b.anchor_index);
  return scene;
}

/// More rows of points and objects, filled with values that must not matter.
RandomScene padded(RandomScene scene, std::int64_t more_objects, std::int64_t more_points) {
  SceneBatch& b = scene.batch;
  for (Tensor* rows : {&b.points_reference, &b.normals_reference}) {
    *rows = torch::constant_pad_nd(*rows, {0, 0, 0, more_points, 0, more_objects}, 7.5);
  }
  b.point_mask = torch::constant_pad_nd(b.point_mask, {0, more_points, 0, more_objects}, false);
  for (Tensor* mask : {&b.object_mask, &b.dynamic_mask}) {
    *mask = torch::constant_pad_nd(*mask, {0, more_objects}, false);
  }
  for (Tensor* rows : {&b.anchor_index, &b.properties, &b.properties_known}) {
    *rows = torch::constant_pad_nd(*rows, {0, 0, 0, more_objects}, 0);
  }
  for (Pose* pose : {&scene.state.first, &scene.state.previous, &scene.state.current}) {
    const Tensor identity = torch::eye(3, pose->rotation.options());
    const std::int64_t B = b.points_reference.size(0);
    pose->rotation = torch::cat({pose->rotation, identity.expand({B, more_objects, 3, 3})}, 1);
    pose->translation = torch::constant_pad_nd(pose->translation, {0, 0, 0, more_objects}, 0.5);
  }
  return scene;
}

/// Scene `i` of a batch on its own, without its padding.
RandomScene alone(RandomScene scene, std::int64_t i) {
  const std::int64_t K = scene.batch.object_mask[i].sum().item<std::int64_t>();
  const std::int64_t N = scene.batch.point_mask[i].sum(-1).max().item<std::int64_t>();
  for_each_object_tensor(scene, [&](Tensor& tensor) { tensor = tensor.slice(0, i, i + 1).slice(1, 0, K); });
  for_each_scene_tensor(scene, [&](Tensor& tensor) { tensor = tensor.slice(0, i, i + 1); });
  scene.batch.points_reference = scene.batch.points_reference.slice(2, 0, N);
  scene.batch.normals_reference = scene.batch.normals_reference.slice(2, 0, N);
  scene.batch.point_mask = scene.batch.point_mask.slice(2, 0, N);
  return scene;
}

/// The network's addition to the base motion [m].
Tensor network_share(const ModelOptions& options, const RandomScene& scene, const StepPrediction& prediction,
                     RigidFormer& model) {
  const Tensor centre = model->centre_of_mass(scene.batch, scene.state.current);
  const BaseMotion base = make_base_motion(options, scene.batch, scene.state, centre);
  return prediction.anchors_raw - base.apply(scene.batch.anchors_reference());
}

std::vector<Tensor*> parts_of(StepPrediction& p) {
  return {&p.anchors_raw, &p.pose.rotation, &p.pose.translation, &p.departure.rotation, &p.departure.translation};
}

void expect_same(StepPrediction a, StepPrediction b, double tolerance = kSameToRounding) {
  const std::vector<Tensor*> parts_a = parts_of(a), parts_b = parts_of(b);
  for (size_t i = 0; i < parts_a.size(); ++i) EXPECT_LT(largest_difference(*parts_a[i], *parts_b[i]), tolerance) << i;
}

TEST(RigidFormerTest, TheNetworkMovesAnchorsVisibly) {
  const RandomScene scene = random_scene(1, {{20, 9, 16}});
  for (const ModelOptions& options : tiny_variants()) {
    RigidFormer model = random_model(options);
    EXPECT_GT(network_share(options, scene, predict(model, scene), model).abs().max().item<double>(), kVisible);
  }
}

TEST(RigidFormerTest, PermutedObjectsGivePermutedPredictions) {
  const RandomScene scene = random_scene(1, {{20, 9, 16, 12}, {12, 17, 8, 8}});
  const Tensor order = torch::tensor({2, 0, 3, 1}, torch::kInt64);
  for (ModelOptions options : tiny_variants()) {
    for (const std::string& name : encoding_names()) {
      if (name == "learned") continue;  // an index embedding breaks the symmetry
      SCOPED_TRACE(name);
      options.position_encoding = position_encoding_from_string(name);
      RigidFormer model = random_model(options);
      StepPrediction expected = predict(model, scene);
      for (Tensor* tensor : parts_of(expected)) {
        *tensor = tensor->index_select(1, order);
      }
      expect_same(predict(model, reordered_objects(scene, order)), expected);
    }
  }
}

TEST(RigidFormerTest, LearnedIndexEmbeddingDependsOnObjectOrder) {
  const RandomScene scene = random_scene(1, {{20, 9, 16}});
  const Tensor order = torch::tensor({2, 0, 1}, torch::kInt64);
  ModelOptions options;
  options.position_encoding = PositionEncoding::kLearned;
  RigidFormer model = random_model(options);
  const Tensor straight = predict(model, scene).anchors_raw.index_select(1, order);
  EXPECT_GT(largest_difference(predict(model, reordered_objects(scene, order)).anchors_raw, straight), kVisible);
}

TEST(RigidFormerTest, ReindexedAnchorsGiveTheSamePose) {
  const RandomScene scene = random_scene(2, kMixedScenes);
  const Tensor order = torch::tensor({3, 1, 0, 2}, torch::kInt64);
  RandomScene reindexed = scene;
  reindexed.batch.anchor_index = scene.batch.anchor_index.index_select(2, order);
  for (ModelOptions options : tiny_variants()) {
    for (const std::string& name : encoding_names()) {
      SCOPED_TRACE(name);
      options.position_encoding = position_encoding_from_string(name);
      RigidFormer model = random_model(options);
      StepPrediction expected = predict(model, scene);
      expected.anchors_raw = expected.anchors_raw.index_select(2, order);
      const StepPrediction actual = predict(model, reindexed);
      const Tensor valid = scene.batch.object_mask.unsqueeze(-1).to(torch::kFloat64);
      EXPECT_LT(largest_difference(actual.anchors_raw, expected.anchors_raw), kSameToRounding);
      EXPECT_LT(largest_difference(actual.pose.translation * valid, expected.pose.translation * valid),
                kSameToRounding);
      EXPECT_LT(
          largest_difference(actual.pose.rotation * valid.unsqueeze(-1), expected.pose.rotation * valid.unsqueeze(-1)),
          kSameToRounding);
    }
  }
}

TEST(RigidFormerTest, VertexOrderMattersOnlyThroughThePoolingLevels) {
  const RandomScene scene = random_scene(3, kMixedScenes);
  const RandomScene shuffled = reordered_points(scene);
  for (const ModelOptions& options : tiny_variants()) {
    RigidFormer model = random_model(options);
    EXPECT_GT(largest_difference(predict(model, shuffled).anchors_raw, predict(model, scene).anchors_raw), 1e-7);
    torch::NoGradGuard no_grad;
    // Keeps only the level of all points.
    model->encoder->fuse->first->weight.slice(1, options.encoder_widths.back()).zero_();
    expect_same(predict(model, shuffled), predict(model, scene));
  }
}

TEST(RigidFormerTest, PaddedPointsAndObjectsChangeNothing) {
  const RandomScene scene = random_scene(4, kMixedScenes);
  const RandomScene larger = padded(scene, 2, 11);
  for (ModelOptions options : tiny_variants()) {
    for (const std::string& name : encoding_names()) {
      SCOPED_TRACE(name);
      options.position_encoding = position_encoding_from_string(name);
      RigidFormer model = random_model(options);
      const StepPrediction expected = predict(model, scene);
      StepPrediction actual = predict(model, larger);
      EXPECT_TRUE(torch::isfinite(actual.anchors_raw).all().item<bool>());
      for (Tensor* tensor : parts_of(actual)) {
        *tensor = tensor->slice(1, 0, 3);
      }
      const Tensor valid = scene.batch.object_mask;
      EXPECT_LT(largest_difference(actual.anchors_raw.index({valid}), expected.anchors_raw.index({valid})),
                kSameToRounding);
      EXPECT_LT(largest_difference(actual.pose.rotation.index({valid}), expected.pose.rotation.index({valid})),
                kSameToRounding);
      EXPECT_LT(largest_difference(actual.pose.translation.index({valid}), expected.pose.translation.index({valid})),
                kSameToRounding);
    }
  }
}

TEST(RigidFormerTest, BatchAndOneByOneAgree) {
  const RandomScene scene = random_scene(5, {{20, 9, 16}, {12, 17}, {30}});
  for (const ModelOptions& options : tiny_variants()) {
    RigidFormer model = random_model(options);
    const StepPrediction together = predict(model, scene);
    for (std::int64_t i = 0; i < 3; ++i) {
      StepPrediction expected = together;
      const std::int64_t K = scene.batch.object_mask[i].sum().item<std::int64_t>();
      for (Tensor* tensor : parts_of(expected)) {
        *tensor = tensor->slice(0, i, i + 1).slice(1, 0, K);
      }
      expect_same(predict(model, alone(scene, i)), expected);
    }
  }
}

TEST(RigidFormerTest, RolloutsStayRigid) {
  RandomScene scene = random_scene(6, kMixedScenes, 4, 0, torch::kFloat32);
  for (const ModelOptions& options : tiny_variants()) {
    RigidFormer model = random_model(options, torch::kFloat32);
    SceneState state = scene.state;
    for (int step = 0; step < 10; ++step) state = advance(scene.batch, state, predict(model, {scene.batch, state}));
    const Tensor R = state.current.rotation;
    EXPECT_LT(largest_difference(torch::matmul(R.transpose(-1, -2), R), torch::eye(3).expand_as(R)), 1e-5);
    EXPECT_GT(torch::det(R).min().item<double>(), 0.999);
    const Tensor before = scene.batch.points_reference[0], after = state.current.apply(scene.batch.points_reference)[0];
    EXPECT_LT(largest_difference(torch::cdist(after, after, 2, 2), torch::cdist(before, before, 2, 2)), 1e-5);
    EXPECT_GT(largest_difference(state.current.translation, scene.state.current.translation), 1e-2);
  }
}

TEST(RigidFormerTest, SameSeedSameWeightsSamePrediction) {
  const RandomScene scene = random_scene(7, kMixedScenes, 4, 0, torch::kFloat32);
  const auto predict_with_seed = [&](std::uint64_t seed) {
    RigidFormer model = random_model(contact_aware(model_preset("tiny")), torch::kFloat32, seed);
    return predict(model, scene).anchors_raw;
  };
  const Tensor first = predict_with_seed(11);
  EXPECT_TRUE(torch::equal(predict_with_seed(11), first));
  EXPECT_FALSE(torch::equal(predict_with_seed(12), first));
}

TEST(RigidFormerTest, LowerPrecisionStaysClose) {
  const RandomScene wide = random_scene(8, kMixedScenes);
  const RandomScene narrow = random_scene(8, kMixedScenes, 4, 0, torch::kFloat32);
  for (const ModelOptions& options : tiny_variants()) {
    RigidFormer model64 = random_model(options), model32 = random_model(options, torch::kFloat32);
    const StepPrediction exact = predict(model64, wide);
    const double share = network_share(options, wide, exact, model64).abs().max().item<double>();
    EXPECT_LT(largest_difference(predict(model32, narrow).anchors_raw, exact.anchors_raw), 1e-4 * std::max(share, 0.1));
    model32->set_compute_type(torch::kBFloat16);
    const StepPrediction coarse = predict(model32, narrow);
    EXPECT_EQ(coarse.anchors_raw.scalar_type(), torch::kFloat32);
    EXPECT_LT(largest_difference(coarse.anchors_raw, exact.anchors_raw), 0.1 * share);
  }
}

TEST(RigidFormerTest, StepSizeChangesThePredictionThroughTheCode) {
  RandomScene scene = random_scene(9, {{20, 9}});
  RigidFormer model = random_model(model_preset("tiny"));
  const auto acceleration = [&](double s) {
    scene.batch.step_size.fill_(s);
    const double dt = s / kFrameRateHz;
    return network_share(model->options, scene, predict(model, scene), model) / (dt * dt);
  };
  EXPECT_GT(largest_difference(acceleration(1.0), acceleration(10.0)), 1e-3);
}

}  // namespace
}  // namespace rigidformer
