// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/weight_transfer.hpp"

#include <gtest/gtest.h>

#include "random_scene.hpp"
#include "rigidformer/data/example_archive.hpp"

namespace rigidformer {
namespace {

TEST(TransferWeights, AnExtendedModelBeginsAsTheOneItComesFrom) {
  ModelOptions options = contact_aware(model_preset("tiny"));
  options.end_velocity_output = false;
  RigidFormer old_model = random_model(options);
  options.end_velocity_output = true;
  RigidFormer new_model = random_model(options);
  transfer_weights(old_model, new_model);
  const RandomScene scene = random_scene(1, {{20, 9, 16}});
  const StepPrediction expected = predict(old_model, scene), actual = predict(new_model, scene);
  EXPECT_LT(largest_difference(actual.anchors_raw, expected.anchors_raw), 1e-12);
  EXPECT_LT(largest_difference(actual.departure.rotation, scene.state.current.rotation), 1e-9);
  EXPECT_LT(largest_difference(actual.departure.translation, scene.state.current.translation), 1e-9);
}

TEST(TransferWeights, AModelThatLearnsToReadTheGroundBeginsAsTheOneThatDoesNot) {
  ModelOptions options = token_options();
  RigidFormer old_model = random_model(options);
  options.ground_material = true;
  RigidFormer new_model = random_model(options);
  transfer_weights(old_model, new_model);
  RandomScene scene = random_scene(1, {{20, 9, 16}});
  scene.batch.ground_material = torch::tensor({{0.7, 0.2}}, torch::kFloat64);
  scene.batch.ground_known = torch::ones({1, 2}, torch::kFloat64);
  EXPECT_LT(largest_difference(predict(new_model, scene).anchors_raw, predict(old_model, scene).anchors_raw), 1e-12);
}

TEST(TransferWeights, ModelsThatDoNotFitAreRefusedByTensor) {
  ModelOptions options = model_preset("tiny");
  const RigidFormer tiny(options);
  options.embedding_dim = 32;
  RigidFormer narrow(options);
  const std::string message = error_of([&] { transfer_weights(tiny, narrow); });
  EXPECT_NE(message.find("does not fit into"), std::string::npos) << message;
  options = model_preset("tiny");
  options.num_layers = 3;
  options.scales = {0, 1, 2, 3};
  RigidFormer shallow(options);
  const std::string missing = error_of([&] { transfer_weights(tiny, shallow); });
  EXPECT_NE(missing.find("has no tensor 'decoder"), std::string::npos) << missing;
}

}  // namespace
}  // namespace rigidformer
