// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/training/losses.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigidformer/model/random_scene.hpp"

namespace rigidformer {
namespace {

/// One or more objects whose prediction misses by the same vectors everywhere; the time step is 0.5 s.
struct Miss {
  RandomScene scene;
  StepPrediction prediction;
  Pose truth;

  explicit Miss(int num_objects)
      : scene(random_scene(1, {std::vector<std::int64_t>(static_cast<size_t>(num_objects), 6)})) {
    scene.batch.step_size.fill_(120.0);
    truth = scene.state.current;
    const Tensor raw = torch::tensor({0.5, 0.0, 0.0}, torch::kFloat64), rigid = raw.roll(1) * 4.0;
    prediction.anchors_raw = truth.apply(scene.batch.anchors_reference()) + raw;
    prediction.pose = {truth.rotation, truth.translation + rigid};
  }

  double loss(const LossOptions& options) const {
    return step_loss(options, scene.batch, prediction, truth).item<double>();
  }
};

TEST(StepLoss, MatchesHandComputedValues) {
  const Miss miss(1);
  LossOptions options;
  // Positions: smooth(0.5) + smooth(2) = 0.125 + 1.5. Residuals / dt^2: smooth(2) + smooth(8) = 1.5 + 7.5.
  EXPECT_NEAR(miss.loss(options), 10.0 * 1.625 + 9.0, 1e-9);
  options.residual_unit = "dt";  // smooth(1) + smooth(4) = 0.5 + 3.5
  EXPECT_NEAR(miss.loss(options), 10.0 * 1.625 + 4.0, 1e-9);
  options.residual_unit = "frames2";  // smooth(0.5 / 120^2) + smooth(2 / 120^2)
  EXPECT_NEAR(miss.loss(options), 10.0 * 1.625 + 0.5 * (0.25 + 4.0) / std::pow(120.0, 4), 1e-9);
  options.residual_unit = "dt";
  options.position_weight = 0.0;
  options.acceleration_weight = 3.0;
  EXPECT_NEAR(miss.loss(options), 12.0, 1e-9);
  options.beta = 2.0;  // 0.5 * 1 / 2 + (4 - 1)
  EXPECT_NEAR(miss.loss(options), 3.0 * 3.25, 1e-9);
}

TEST(StepLoss, IsTheMeanOverValidDynamicObjects) {
  Miss miss(3);
  LossOptions options;
  const double expected = Miss(1).loss(options);
  EXPECT_NEAR(miss.loss(options), expected, 1e-9);  // all objects miss by the same
  for (Tensor* tensor : {&miss.prediction.anchors_raw, &miss.prediction.pose.translation}) {
    tensor->select(1, 1).add_(100.0);
    tensor->select(1, 2).add_(100.0);
  }
  EXPECT_GT(miss.loss(options), 100.0);
  miss.scene.batch.object_mask[0][1] = false;   // this object is padding
  miss.scene.batch.dynamic_mask[0][2] = false;  // this object is static: its prediction is not used
  EXPECT_NEAR(miss.loss(options), expected, 1e-9);
  miss.scene.batch.object_mask.fill_(false);
  EXPECT_EQ(miss.loss(options), 0.0);
}

TEST(StepLoss, PerfectPredictionCostsNothing) {
  Miss miss(2);
  miss.prediction = {miss.truth.apply(miss.scene.batch.anchors_reference()), miss.truth, miss.truth};
  EXPECT_EQ(miss.loss({}), 0.0);
}

TEST(EndVelocityLoss, ComparesTheStepsThatLeadOn) {
  Miss miss(1);
  LossOptions options;
  options.end_velocity_weight = 2.0;
  const auto loss = [&](double x) {
    miss.prediction.pose = miss.truth;
    miss.prediction.departure = miss.truth;  // predicted to stand still; in truth it moves along x, time step 0.5 s
    Pose departure = miss.truth;
    departure.translation = departure.translation - torch::tensor({x, 0.0, 0.0}, torch::kFloat64);
    return end_velocity_loss(options, miss.scene.batch, miss.prediction, miss.truth, departure).item<double>();
  };
  EXPECT_NEAR(loss(0.0), 0.0, 1e-12);
  EXPECT_NEAR(loss(0.25), 2.0 * 0.5 * 0.5 * 0.5, 1e-9);  // 0.5 m/s, on the parabola of Smooth L1
  EXPECT_NEAR(loss(2.0), 2.0 * 3.5, 1e-9);               // 4 m/s, on the line of Smooth L1
}

TEST(CentreOfMassLoss, CountsInBoundingRadii) {
  RandomScene scene = random_scene(1, {{5}});
  scene.batch.points_reference = 2.0 * scene.batch.points_reference / scene.batch.points_reference.norm(2, -1, true);
  LossOptions options;
  options.centre_of_mass_weight = 3.0;
  const auto loss = [&](double x) {
    const Tensor centre = torch::tensor({x, 0.0, 0.0}, torch::kFloat64).view({1, 1, 3});
    return centre_of_mass_loss(options, scene.batch, centre).item<double>();
  };
  EXPECT_EQ(loss(0.0), 0.0);
  EXPECT_NEAR(loss(1.0), 3.0 * (0.5 - 0.05), 1e-9);             // half a radius, on the line of Smooth L1
  EXPECT_NEAR(loss(0.1), 3.0 * 0.5 * 0.05 * 0.05 / 0.1, 1e-9);  // a twentieth of a radius, on the parabola of Smooth L1
}

/// A ball of unit radius of which the upper half is seen, in double precision.
WindowBatch half_a_ball() {
  torch::manual_seed(6);
  const Tensor drawn = torch::randn({1, 1, 2000, 3}, torch::kFloat64);
  WindowBatch windows;
  windows.whole_surface = drawn / drawn.norm(2, -1, true);
  windows.whole_mask = torch::ones({1, 1, 2000}, torch::kBool);
  SceneBatch& scene = windows.scene;
  scene.surface_points = windows.whole_surface;
  scene.surface_mask = windows.whole_surface.select(-1, 2) > 0.0;
  scene.point_mask = torch::ones({1, 1, 2000}, torch::kBool);
  scene.object_mask = torch::ones({1, 1}, torch::kBool);
  scene.properties = torch::zeros({1, 1, 3}, torch::kFloat64);
  return windows;
}

TEST(HiddenSideLoss, CountsHowFarTheCompletedHullIsFromTheWhole) {
  WindowBatch windows = half_a_ball();
  LossOptions options;
  const auto loss = [&](const Tensor& hidden) { return hidden_side_loss(options, windows, hidden).item<double>(); };
  const double nothing_guessed = loss(torch::zeros_like(windows.whole_surface));
  const double mirrored = loss(-windows.whole_surface);
  EXPECT_LT(mirrored, 1e-2 * nothing_guessed);
  EXPECT_GT(loss(-2.0 * windows.whole_surface), nothing_guessed) << "reaching out too far costs too";
  EXPECT_EQ(loss(windows.whole_surface), 0.0);
  options.hidden_side_weight = 3.0;
  torch::manual_seed(1);
  const double weighted = loss(torch::zeros_like(windows.whole_surface));
  options.hidden_side_weight = 1.0;
  torch::manual_seed(1);
  EXPECT_NEAR(weighted, 3.0 * loss(torch::zeros_like(windows.whole_surface)), 1e-9);
  windows.scene.object_mask.fill_(false);
  EXPECT_EQ(loss(torch::zeros_like(windows.whole_surface)), 0.0);
}

/// A window whose truth is the rollout of the model itself, with the last step missed by `miss` metres along x.
WindowBatch own_rollout(RigidFormer& model, const RandomScene& scene, int num_steps, double miss) {
  WindowBatch windows;
  windows.scene = scene.batch;
  windows.poses = {scene.state.previous, scene.state.current};
  SceneState state{scene.state.previous, scene.state.previous, scene.state.current};
  for (int step = 0; step < num_steps; ++step) {
    const StepPrediction prediction = predict(model, {scene.batch, state});
    state = advance(scene.batch, state, prediction);
    windows.poses.push_back(state.current);
    windows.departures.push_back(prediction.departure);
  }
  windows.poses.back().translation =
      windows.poses.back().translation + miss * torch::tensor({1.0, 0.0, 0.0}, torch::kFloat64);
  return windows;
}

TEST(WindowLoss, RollsTheModelOut) {
  const RandomScene scene = random_scene(2, {{12, 9}, {8}});
  RigidFormer model = random_model(model_preset("tiny"));
  LossOptions options;
  options.acceleration_weight = 0.0;
  options.position_weight = 1.0;
  // The raw anchors are not quite rigid, so only the rigid half of the loss vanishes.
  const double perfect =
      window_loss(options, model, own_rollout(model, scene, 3, 0.0), nearest_by_distance_matrix).item<double>();
  const double missed =
      window_loss(options, model, own_rollout(model, scene, 3, 5.0), nearest_by_distance_matrix).item<double>();
  EXPECT_LT(perfect, 0.01);
  EXPECT_NEAR(missed, 2.0 * 4.5 / 3.0, 0.05);  // one step out of three misses, raw and rigid
}

/// A window of which object 0 is driven with an acceleration that no twist tells.
WindowBatch driven_windows(const RandomScene& scene, int num_steps) {
  WindowBatch windows;
  windows.scene = scene.batch;
  windows.scene.dynamic_mask = scene.batch.dynamic_mask.clone();
  windows.scene.dynamic_mask.select(1, 0).fill_(false);
  windows.poses = {scene.state.previous, scene.state.current};
  for (int step = 1; step <= num_steps; ++step) {
    Pose pose = nudged(scene.state.current);
    pose.translation.select(1, 0).select(-1, 0).add_(0.1 * step * step);
    windows.poses.push_back(pose);
    windows.departures.push_back(nudged(pose));
  }
  return windows;
}

TEST(WindowLoss, TellsTheModelWhereDrivenBodiesAreAboutToBe) {
  const RandomScene scene = random_scene(2, {{12, 9}, {8}});
  RigidFormer model = random_model(model_preset("tiny"));
  const WindowBatch windows = driven_windows(scene, 3);
  const auto loss_of = [&](bool is_told) {
    SceneState state{windows.poses[0], windows.poses[0], windows.poses[1]};
    double loss = 0.0;
    for (size_t step = 0; step < 3; ++step) {
      if (is_told) state.coming = windows.poses[step + 2];
      const StepPrediction prediction = predict(model, {windows.scene, state});
      loss += step_loss({}, windows.scene, prediction, windows.poses[step + 2]).item<double>() / 3.0;
      state = advance(windows.scene, state, prediction);
    }
    return loss;
  };
  LossOptions options;
  options.centre_of_mass_weight = 0.0;
  const double loss = window_loss(options, model, windows, nearest_by_distance_matrix).item<double>();
  EXPECT_NEAR(loss, loss_of(true), 1e-9 * loss);
  EXPECT_GT(std::abs(loss - loss_of(false)), 1e-6 * loss);
}

TEST(WindowLoss, NothingIsLearnedFromGivenBodies) {
  const RandomScene scene = random_scene(2, {{12, 9}, {8}});
  for (const ModelOptions& options : tiny_variants()) {
    RigidFormer model = random_model(options);
    WindowBatch windows = driven_windows(scene, 2);
    windows.scene.dynamic_mask.fill_(false);
    LossOptions losses;
    losses.centre_of_mass_weight = 1.0;
    const Tensor loss = window_loss(losses, model, windows, nearest_by_distance_matrix);
    EXPECT_EQ(loss.item<double>(), 0.0);
    loss.backward();
    for (const Tensor& parameter : model->parameters()) {
      const Tensor gradient = parameter.grad();
      EXPECT_TRUE(!gradient.defined() || gradient.abs().max().item<double>() == 0.0);
    }
  }
}

TEST(WindowLoss, GradientMatchesTheDifferenceQuotient) {
  const RandomScene scene = random_scene(3, {{12, 9}, {8}});
  for (const ModelOptions& options : tiny_variants()) {
    RigidFormer model = random_model(options);
    const WindowBatch windows = own_rollout(model, scene, 2, 0.5);
    std::vector<Tensor> parameters, directions;
    torch::manual_seed(4);
    for (const auto& parameter : model->named_parameters()) {
      if (parameter.key().rfind("centre_of_mass_head", 0) == 0) continue;  // this head learns from its own loss alone
      parameters.push_back(parameter.value());
      directions.push_back(torch::randn_like(parameter.value()).detach());
    }
    const auto loss = [&] { return window_loss({}, model, windows, nearest_by_distance_matrix); };
    loss().backward();
    double analytic = 0.0;
    for (size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].grad().defined()) analytic += (parameters[i].grad() * directions[i]).sum().item<double>();
    }
    torch::NoGradGuard no_grad;
    const double h = 1e-7;
    const auto move = [&](double step) {
      for (size_t i = 0; i < parameters.size(); ++i) parameters[i].add_(directions[i], step);
    };
    move(h);
    const double above = loss().item<double>();
    move(-2.0 * h);
    const double below = loss().item<double>();
    EXPECT_NEAR((above - below) / (2.0 * h), analytic, 1e-5 * std::max(1.0, std::abs(analytic)));
    EXPECT_GT(std::abs(analytic), 1e-4);
  }
}

}  // namespace
}  // namespace rigidformer
