// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <stdexcept>

#include "random_scene.hpp"
#include "rigidformer/data/example_archive.hpp"

namespace rigidformer {
namespace {

TEST(ControlTest, ItsCodeReachesThePrediction) {
  ModelOptions options = model_preset("tiny");
  options.control_dim = 2;
  RigidFormer model = random_model(options);
  RandomScene scene = random_scene(3, {{20, 9}}, 4, 2);
  const Tensor before = predict(model, scene).anchors_raw;
  scene.batch.control = scene.batch.control + 1.0;
  EXPECT_GT(largest_difference(predict(model, scene).anchors_raw, before), 1e-6);
}

TEST(ControlTest, ScenesWithoutTheirCommandAreRefused) {
  ModelOptions options = model_preset("tiny");
  options.control_dim = 2;
  RigidFormer model = random_model(options);
  const RandomScene silent = random_scene(3, {{20, 9}}), long_winded = random_scene(3, {{20, 9}}, 4, 3);
  EXPECT_NE(error_of([&] { predict(model, silent); }).find("a command of 0 numbers, the model wants 2"),
            std::string::npos);
  EXPECT_NE(error_of([&] { predict(model, long_winded); }).find("a command of 3 numbers"), std::string::npos);
  RigidFormer free_model = random_model(model_preset("tiny"));
  EXPECT_THROW(predict(free_model, long_winded), std::invalid_argument) << "nor is a command overheard";
}

}  // namespace
}  // namespace rigidformer
