// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "rigidformer/data/example_archive.hpp"
#include "rigidformer/model/checkpoint.hpp"
#include "rigidformer/model/random_scene.hpp"
#include "rigidformer/predictor.hpp"

namespace rigidformer {
namespace {

using Commands = std::vector<std::vector<double>>;

class CommandedPredictor : public ::testing::Test {
 protected:
  CommandedPredictor() {
    ModelOptions model = contact_aware(model_preset("tiny"));
    model.control_dim = 2;
    TrainingFacts facts;
    facts.min_step_frames = 1.0;
    facts.max_step_frames = 10.0;
    PredictorOptions options{(folder_.path() / "model.safetensors").string(), "cpu", "float32", 1, 256, 1};
    save_checkpoint(options.file, random_model(model, torch::kFloat32), facts);
    predictor_ = std::make_unique<Predictor>(options);
    std::srand(5);
    cloud_ = 0.5F * Points::Random(24, 3);
  }

  /// Path of an object that touches the ground.
  std::vector<RigidTransform> path(const Commands& control, int num_steps = 4) {
    ObjectState object;
    object.id = "part";
    object.points_reference = cloud_;
    object.T_world_current.translation.z() = object.T_world_previous.translation.z() = 0.2;
    RolloutOptions rollout;
    rollout.num_steps = num_steps;
    rollout.control = control;
    return predictor_->predict({object}, rollout).objects.at(0).poses;
  }

  static double distance(const RigidTransform& a, const RigidTransform& b) {
    return (a.translation - b.translation).norm();
  }

  const TemporaryFolder folder_;
  std::unique_ptr<Predictor> predictor_;
  Points cloud_;
};

TEST_F(CommandedPredictor, CommandsMayChangeDuringARollout) {
  EXPECT_NO_THROW(predictor_->warm_up());
  EXPECT_EQ(predictor_->info().control_dim, 2);
  const std::vector<double> a{0.5, -1.0}, b{-0.5, 1.0};
  const auto held = path({a}), repeated = path({a, a, a, a}), changed = path({a, a, b, b});
  for (std::size_t k = 0; k < held.size(); ++k) EXPECT_EQ(distance(held[k], repeated[k]), 0.0);
  EXPECT_EQ(distance(held[2], changed[2]), 0.0);
  EXPECT_GT(distance(held[3], changed[3]), 0.0);
}

TEST_F(CommandedPredictor, RefusesOtherCommands) {
  EXPECT_THROW(path({}), std::invalid_argument);
  EXPECT_THROW(path({{1.0}}), std::invalid_argument);
  EXPECT_THROW(path({{1.0, 2.0}, {1.0, 2.0}}), std::invalid_argument) << "two commands for four steps";
}

}  // namespace
}  // namespace rigidformer
