// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cubes.hpp"
#include "rigidformer/engine/engine_step.hpp"

namespace rigidformer {
namespace {

/// Cubes of which several advisers say how they move.
struct AdvisedCubes : Cubes {
  using Cubes::Cubes;

  EngineStep advised_by(int advisers) const {
    ModelOptions options = engine_options();
    options.advisers = advisers;
    return make_engine_step(options, batch, centre);
  }
};

TEST(Advisers, DifferWhereMaterialIsUnknown) {
  AdvisedCubes cubes(2);
  cubes.place(0, {0.0, 0.0, 0.51}, {1.0, 0.0, -2.0});
  cubes.place(1, {3.0, 0.0, 0.51}, {1.0, 0.0, -2.0});
  cubes.batch.properties_known[0][1] = 0.0;
  const std::vector<EngineMotion> advice = cubes.advised_by(3)(cubes.state);
  ASSERT_EQ(advice.size(), 3u);
  const auto velocity = [&](std::size_t adviser, std::int64_t k) {
    return (advice[adviser].pose.translation - advice[adviser].departure.translation)[0][k] / kTimeStep_s;
  };
  EXPECT_LT(largest_difference(velocity(0, 0), velocity(1, 0)), 1e-4);
  EXPECT_LT(largest_difference(velocity(0, 0), velocity(2, 0)), 1e-4);
  EXPECT_GT(velocity(0, 1)[2].item<double>(), velocity(1, 1)[2].item<double>() + 0.3) << "the second does not bounce";
  EXPECT_LT(velocity(2, 1)[0].item<double>(), velocity(0, 1)[0].item<double>() - 0.1) << "the third does not slide";
}

TEST(Advisers, SayTheSameWhereNothingIsGuessed) {
  AdvisedCubes cubes(1);
  cubes.place(0, {0.0, 0.0, 0.51}, {1.0, 0.0, -2.0});
  const std::vector<EngineMotion> advice = cubes.advised_by(3)(cubes.state);
  ASSERT_EQ(advice.size(), 3u);
  const EngineMotion alone = cubes.advised_by(1)(cubes.state).front();
  for (const EngineMotion& motion : advice) {
    EXPECT_TRUE(torch::equal(motion.pose.translation, alone.pose.translation));
    EXPECT_TRUE(torch::equal(motion.departure.rotation, alone.departure.rotation));
  }
}

/// Three advisers, of which the network trusts `trusted` alone.
RigidFormer model_that_trusts(std::int64_t trusted) {
  ModelOptions options = engine_options();
  options.advisers = 3;
  RigidFormer model = random_model(options);
  model->options.contact_gate = false;
  torch::NoGradGuard no_grad;
  Tensor bias = model->named_parameters()["predictor.head.second.bias"];
  bias.slice(0, 6).fill_(-60.0);
  bias[6 + trusted] = 60.0;
  return model;
}

TEST(Advisers, TheNetworkChoosesAmongThem) {
  RandomScene scene = random_scene(1, {{20, 9, 16}});
  scene.batch.properties_known.zero_();
  for (std::int64_t trusted = 0; trusted < 3; ++trusted) {
    RigidFormer model = model_that_trusts(trusted);
    const Tensor centre = model->centre_of_mass(scene.batch, scene.state.current);
    const auto advice = make_engine_step(model->options, scene.batch, centre)(scene.state);
    const Pose& chosen = advice[static_cast<std::size_t>(trusted)].pose;
    EXPECT_LT(largest_difference(predict(model, scene).pose.translation, chosen.translation), 1e-9);
  }
}

}  // namespace
}  // namespace rigidformer
