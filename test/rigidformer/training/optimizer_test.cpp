// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/optimizer.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "rigidformer/model/layers.hpp"
#include "rigidformer/model/random_scene.hpp"

namespace rigidformer {
namespace {

class FlatAdamWTest : public ::testing::Test {
 protected:
  FlatAdamWTest() {
    torch::manual_seed(6);
    module_ = Mlp(3, 5, 2);
    x_ = torch::randn({16, 3});
    y_ = torch::randn({16, 2});
    options_.clip_norm = 1e9;
    options_.weight_decay = 0.1;
  }

  Tensor loss(Mlp& module) const { return (module(x_) - y_).square().mean(); }

  std::vector<Tensor> copied_parameters() {
    std::vector<Tensor> copies;
    for (const Tensor& parameter : module_->parameters()) copies.push_back(parameter.detach().clone());
    return copies;
  }

  double change_since(const std::vector<Tensor>& before) {
    double largest = 0.0;
    const auto now = module_->parameters();
    for (size_t i = 0; i < now.size(); ++i) largest = std::max(largest, largest_difference(now[i], before[i]));
    return largest;
  }

  Tensor learn(FlatAdamW& optimizer, double rate = 0.02) {
    optimizer.zero_gradient();
    loss(module_).backward();
    return optimizer.step(rate);
  }

  Mlp module_{nullptr};
  Tensor x_, y_;
  OptimizerOptions options_;
};

TEST(LearningRate, WarmsUpLinearlyThenFollowsTheCosine) {
  OptimizerOptions options;
  options.learning_rate = 1e-2;
  options.final_learning_rate = 1e-4;
  options.warmup = 0.2;
  EXPECT_NEAR(learning_rate_at(options, 0.0), 1e-3, 1e-12);
  EXPECT_NEAR(learning_rate_at(options, 0.1), 5.5e-3, 1e-12);
  EXPECT_NEAR(learning_rate_at(options, 0.2), 1e-2, 1e-12);
  EXPECT_NEAR(learning_rate_at(options, 0.6), 0.5 * (1e-2 + 1e-4), 1e-12);
  EXPECT_NEAR(learning_rate_at(options, 0.4), 1e-4 + 0.5 * (1e-2 - 1e-4) * (1.0 + std::sqrt(0.5)), 1e-12);
  EXPECT_NEAR(learning_rate_at(options, 1.0), 1e-4, 1e-12);
  EXPECT_NEAR(learning_rate_at(options, 1.5), 1e-4, 1e-12);
  options.warmup = 0.0;
  EXPECT_NEAR(learning_rate_at(options, 0.0), 1e-2, 1e-12);
}

TEST_F(FlatAdamWTest, EqualsTorchAdamW) {
  Mlp reference(3, 5, 2);
  std::vector<Tensor> matrices, vectors;
  {
    torch::NoGradGuard no_grad;
    const auto source = module_->parameters();
    auto target = reference->parameters();
    for (size_t i = 0; i < source.size(); ++i) {
      target[i].copy_(source[i]);
      (target[i].dim() >= 2 ? matrices : vectors).push_back(target[i]);
    }
  }
  options_.beta1 = 0.8;
  options_.beta2 = 0.95;
  const auto torch_options = [&](double decay) {
    return std::make_unique<torch::optim::AdamWOptions>(
        torch::optim::AdamWOptions(0.02).betas({0.8, 0.95}).eps(1e-8).weight_decay(decay));
  };
  std::vector<torch::optim::OptimizerParamGroup> groups;
  groups.emplace_back(matrices, torch_options(0.1));
  groups.emplace_back(vectors, torch_options(0.0));
  torch::optim::AdamW expected(groups, *torch_options(0.0));
  FlatAdamW optimizer(*module_, options_);
  const std::vector<Tensor> start = copied_parameters();
  for (int step = 0; step < 20; ++step) {
    learn(optimizer);
    expected.zero_grad();
    loss(reference).backward();
    expected.step();
  }
  EXPECT_LT(change_since(reference->parameters()), 1e-5);
  EXPECT_GT(change_since(start), 0.1);
}

TEST_F(FlatAdamWTest, LearnsAndReportsTheGradientNorm) {
  FlatAdamW optimizer(*module_, options_);
  const double before = loss(module_).item<double>();
  optimizer.zero_gradient();
  loss(module_).backward();
  double squares = 0.0;
  for (const Tensor& parameter : module_->parameters()) squares += parameter.grad().square().sum().item<double>();
  EXPECT_NEAR(optimizer.step(0.02).item<double>(), std::sqrt(squares), 1e-5);
  for (int step = 0; step < 300; ++step) learn(optimizer);
  EXPECT_EQ(optimizer.num_steps, 301);
  EXPECT_LT(loss(module_).item<double>(), 0.7 * before);
}

TEST_F(FlatAdamWTest, ClippingScalesTheWholeGradient) {
  options_.clip_norm = 1e-3;
  FlatAdamW optimizer(*module_, options_);
  const double norm = learn(optimizer).item<double>();
  EXPECT_GT(norm, 1e-2);  // the norm before clipping
  Tensor first_moment;
  for (const auto& [name, tensor] : optimizer.state()) {
    if (name == "first_moment") first_moment = tensor;
  }
  EXPECT_NEAR(first_moment.norm().item<double>(), (1.0 - options_.beta1) * 1e-3, 1e-6);
}

TEST_F(FlatAdamWTest, SurvivesGradientsThatAreNotFinite) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    FlatAdamW optimizer(*module_, options_);
    learn(optimizer);
    optimizer.zero_gradient();
    loss(module_).backward();
    module_->first->weight.mutable_grad()[0][0] = value;
    EXPECT_FALSE(std::isfinite(optimizer.step(0.02).item<double>()));
    for (const Tensor& parameter : module_->parameters()) EXPECT_TRUE(torch::isfinite(parameter).all().item<bool>());
    const std::vector<Tensor> before = copied_parameters();
    EXPECT_TRUE(std::isfinite(learn(optimizer).item<double>()));
    EXPECT_GT(change_since(before), 1e-4);
    for (const Tensor& parameter : module_->parameters()) EXPECT_TRUE(torch::isfinite(parameter).all().item<bool>());
  }
}

TEST_F(FlatAdamWTest, SwappingTheAverageTwiceIsTheIdentity) {
  options_.ema_decay = 0.9;
  FlatAdamW optimizer(*module_, options_);
  for (int step = 0; step < 10; ++step) learn(optimizer);
  const std::vector<Tensor> weights = copied_parameters();
  optimizer.swap_average();
  EXPECT_GT(change_since(weights), 1e-3);
  optimizer.swap_average();
  EXPECT_EQ(change_since(weights), 0.0);
}

TEST_F(FlatAdamWTest, AverageFollowsItsDecay) {
  options_.ema_decay = 0.25;  // the first average is younger than that: 2/11
  FlatAdamW optimizer(*module_, options_);
  Tensor expected = module_->first->weight.detach().clone();
  for (int step = 1; step <= 4; ++step) {
    learn(optimizer);
    const double keep = std::min(0.25, (1.0 + step) / (10.0 + step));
    expected = keep * expected + (1.0 - keep) * module_->first->weight.detach();
  }
  optimizer.swap_average();
  EXPECT_LT(largest_difference(module_->first->weight, expected), 1e-6);
}

TEST_F(FlatAdamWTest, WithoutAveragingSwapDoesNothing) {
  FlatAdamW optimizer(*module_, options_);
  learn(optimizer);
  const std::vector<Tensor> weights = copied_parameters();
  optimizer.swap_average();
  EXPECT_EQ(change_since(weights), 0.0);
}

TEST_F(FlatAdamWTest, StateRestoresTheRun) {
  options_.ema_decay = 0.9;
  FlatAdamW optimizer(*module_, options_);
  for (int step = 0; step < 3; ++step) learn(optimizer);
  std::vector<std::pair<std::string, Tensor>> saved;
  for (const auto& [name, tensor] : optimizer.state()) saved.emplace_back(name, tensor.clone());
  for (int step = 0; step < 4; ++step) learn(optimizer);
  const std::vector<Tensor> expected = copied_parameters();
  {
    torch::NoGradGuard no_grad;
    const auto state = optimizer.state();
    for (size_t i = 0; i < saved.size(); ++i) Tensor(state[i].second).copy_(saved[i].second);
  }
  optimizer.num_steps = 3;
  for (int step = 0; step < 4; ++step) learn(optimizer);
  EXPECT_EQ(change_since(expected), 0.0);
}

}  // namespace
}  // namespace rigidformer
