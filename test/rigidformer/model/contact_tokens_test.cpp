// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/contact_tokens.hpp"

#include <gtest/gtest.h>

#include "gradient_check.hpp"
#include "random_scene.hpp"

namespace rigidformer {
namespace {

const auto kDouble = torch::TensorOptions(torch::kFloat64);

/// Two spinning bodies that meet somewhere in the middle of a step, and the second one the ground as well.
class ContactTokensTest : public ::testing::Test {
 protected:
  ContactTokensTest() : scene_(random_scene(3, {{12, 12}})) {
    contacts_.scene = torch::zeros({3}, torch::kInt64);
    contacts_.object = torch::tensor({0, 1, 1}, torch::kInt64);
    contacts_.partner = torch::tensor({1, 0, -1}, torch::kInt64);
    const Tensor arm_0 = torch::tensor({0.3, 0.1, -0.2}, kDouble), arm_1 = torch::tensor({-0.2, 0.4, 0.1}, kDouble);
    const Tensor below = torch::tensor({0.1, -0.1, -0.4}, kDouble), none = torch::zeros({3}, kDouble);
    const Tensor n = torch::tensor({2.0, 1.0, -1.0}, kDouble) / std::sqrt(6.0);
    contacts_.point = torch::stack({arm_0, arm_1, below});
    contacts_.partner_point = torch::stack({arm_1, arm_0, none});
    contacts_.normal = torch::stack({n, -n, torch::tensor({0.0, 0.0, 1.0}, kDouble)});
    contacts_.fraction = torch::tensor({0.3, 0.3, 0.8}, kDouble);
    contacts_.gap = torch::zeros({3}, kDouble);
    contacts_.mass = torch::tensor({{0.7, 2.5}}, kDouble);
    const Tensor root = torch::randn({1, 2, 3, 3}, kDouble);
    contacts_.inverse_inertia = torch::matmul(root, root.transpose(-1, -2)) + torch::eye(3, kDouble);
    centre_ = torch::zeros({1, 2, 3}, kDouble);
  }

  /// The bodies fly towards each other along the normal with 3 m/s each, and the second one down.
  void approach() {
    const Tensor dt = scene_.batch.time_step();
    const Tensor n = contacts_.normal[0];
    Tensor& before = scene_.state.previous.translation;
    before = scene_.state.current.translation.clone();
    before[0][0] += 3.0 * n * dt;
    before[0][1] -= 3.0 * n * dt;
  }

  BaseMotion base() const { return make_base_motion(token_options(), scene_.batch, scene_.state, centre_); }
  ContactDescription describe(const ModelOptions& options = token_options()) const {
    return describe_contacts(options, scene_.batch, scene_.state, base(), contacts_);
  }

  Tensor R(std::int64_t k) const { return scene_.state.current.rotation[0][k]; }
  Tensor inertia(std::int64_t k) const {  // about the centre of mass, world axes
    const Tensor inverse = torch::matmul(R(k), torch::matmul(contacts_.inverse_inertia[0][k], R(k).t()));
    return contacts_.mass[0][k] * torch::inverse(inverse);
  }

  RandomScene scene_;
  Contacts contacts_;
  Tensor centre_;
};

TEST_F(ContactTokensTest, TheGroundIsToldWhereItIsTouchedAndNowhereElse) {
  ModelOptions options = token_options();
  const Tensor without = describe(options).features;
  options.ground_material = true;
  scene_.batch.ground_material = torch::tensor({{0.7, 0.2}}, kDouble);
  scene_.batch.ground_known = torch::tensor({{1.0, 0.0}}, kDouble);
  const Tensor features = describe(options).features;
  ASSERT_EQ(features.size(-1), num_token_features(options));
  EXPECT_TRUE(torch::equal(features.slice(-1, 0, without.size(-1)), without));
  const Tensor told = features.slice(-1, without.size(-1));
  EXPECT_EQ(told.slice(0, 0, 2).abs().max().item<double>(), 0.0) << "contacts between objects";
  EXPECT_TRUE(torch::equal(told[2], torch::tensor({0.7, 0.0, 1.0, 0.0}, kDouble)));
}

TEST_F(ContactTokensTest, UnitAnswersKeepMomentumAndSpin) {
  approach();
  const ContactDescription described = describe();
  EXPECT_GT(described.answers.linear.slice(0, 0, 2).norm(2, -1).min().item<double>(), 1e-3);
  for (std::int64_t answer = 0; answer < 2; ++answer) {
    const Tensor p_0 = contacts_.mass[0][0] * described.answers.linear[0][answer];
    const Tensor p_1 = contacts_.mass[0][1] * described.answers.linear[1][answer];
    EXPECT_LT(largest_difference(p_0, -p_1), 1e-9);
    for (std::int64_t k = 0; k < 2; ++k) {
      const Tensor spin_gained = torch::matmul(inertia(k), described.answers.angular[k][answer]);
      const Tensor moment = torch::cross(contacts_.point[k], k == 0 ? p_0 : p_1, -1);
      EXPECT_LT(largest_difference(spin_gained, moment), 1e-9);
    }
  }
}

/// Velocity of the surface at the own side of contact i that an answer adds.
Tensor gained(const ContactDescription& described, const Contacts& contacts, std::int64_t i, std::int64_t answer) {
  return described.answers.linear[i][answer] +
         torch::cross(described.answers.angular[i][answer], contacts.point[i], -1);
}

TEST_F(ContactTokensTest, TheFirstStopsTheApproachAndTheSecondTheSliding) {
  approach();
  scene_.batch.gravity.zero_();
  const ContactDescription described = describe();
  // Velocities at the contact, by hand: of the centre, and of the turn about it.
  const double dt = scene_.batch.time_step().item<double>();
  const BaseMotion moving = base();
  const auto velocity = [&](std::int64_t k) {
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> turn =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
            torch::matmul(moving.pose.rotation[0][k], R(k).t()).contiguous().data_ptr<double>());
    const Eigen::AngleAxisd angle_axis(Eigen::Matrix3d{turn});
    const Eigen::Vector3d spin = angle_axis.angle() / dt * angle_axis.axis();
    const Tensor w = torch::tensor({spin.x(), spin.y(), spin.z()}, kDouble);
    return moving.centre_step[0][k] / dt + torch::cross(w, contacts_.point[k], -1);
  };
  const Tensor relative = velocity(1) - velocity(0), n = contacts_.normal[0];
  const Tensor approach_speed = (relative * n).sum();
  ASSERT_GT(approach_speed.item<double>(), 1.0);
  const auto closed = [&](std::int64_t answer) {
    return gained(described, contacts_, 0, answer) - gained(described, contacts_, 1, answer);
  };
  EXPECT_NEAR((closed(0) * n).sum().item<double>(), approach_speed.item<double>(), 1e-6);
  const Tensor sliding = relative - approach_speed * n;
  const Tensor t = sliding / sliding.norm();
  EXPECT_NEAR((closed(1) * t).sum().item<double>(), sliding.norm().item<double>(), 1e-6);
  EXPECT_NEAR((described.answers.linear[0][1] * n).sum().item<double>(), 0.0, 1e-9);
}

TEST_F(ContactTokensTest, TheGroundTakesNothing) {
  const ContactDescription described = describe();
  const Tensor down = -gained(described, contacts_, 2, 0)[2];
  scene_.batch.gravity -= 5.0;  // faster downwards: what stops it grows as much
  const double more = -gained(describe(), contacts_, 2, 0)[2].item<double>();
  const double dt = scene_.batch.time_step().item<double>();
  EXPECT_NEAR(down.item<double>() - more, 5.0 * dt * (1.0 + 0.3), 1e-6) << "0.8 of the step is 0.3 past its middle";
}

TEST_F(ContactTokensTest, WhatGoesApartGetsNoPush) {
  approach();
  std::swap(scene_.state.previous, scene_.state.current);
  const ContactDescription described = describe();
  EXPECT_EQ(described.answers.linear[0][0].abs().max().item<double>(), 0.0);
}

TEST_F(ContactTokensTest, GivenMotionIsNotPushed) {
  approach();
  scene_.batch.dynamic_mask[0][1] = false;
  const ContactDescription described = describe();
  EXPECT_EQ(described.answers.linear[1].abs().max().item<double>(), 0.0);
  EXPECT_GT(described.answers.linear[0].abs().max().item<double>(), 0.0);
}

TEST_F(ContactTokensTest, AnswersAreSharesOfTheUnitAnswersAtTheAnchors) {
  approach();
  ContactTokens tokens(token_options());
  tokens->to(torch::kFloat64);
  const Tensor shares = torch::tensor({1.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0}, kDouble);
  torch::NoGradGuard no_grad;
  tokens->share->second->weight.zero_();
  tokens->share->second->bias.copy_(shares);
  const ContactDescription described = describe();
  const Tensor decoded = torch::zeros({1, 2, token_options().embedding_dim}, kDouble);
  const Tensor answer = tokens->answer(tokens->embed(described), described, decoded);
  ASSERT_EQ(answer.sizes(), (std::vector<std::int64_t>{1, 2, 4, 6}));
  const Tensor arm = described.arms[0];  // of body 0, which has one contact
  const Tensor turning = torch::cross(described.answers.angular[0][0].expand_as(arm), arm, -1);
  EXPECT_LT(largest_difference(answer[0][0].slice(-1, 0, 3), described.answers.linear[0][0] + turning), 1e-9);
  EXPECT_LT(largest_difference(answer[0][0].slice(-1, 3, 6), 0.5 * turning), 1e-9);
  const Tensor at_anchors = ContactTokensImpl::to_anchors(described, 1, 2);
  EXPECT_LT(largest_difference(5.0 * at_anchors[0][0].slice(-1, 0, 3), described.answers.linear[0][0] + turning), 1e-9);
}

TEST_F(ContactTokensTest, StartByAddingNothing) {
  ContactTokens tokens(token_options());
  tokens->to(torch::kFloat64);
  const ContactDescription described = describe();
  const Tensor embedded = tokens->embed(described);
  const Tensor objects = torch::randn({1, 2, token_options().embedding_dim}, kDouble);
  EXPECT_EQ(tokens->to_objects(embedded, described, objects).abs().max().item<double>(), 0.0);
  EXPECT_EQ(tokens->answer(embedded, described, objects).abs().max().item<double>(), 0.0);
}

TEST_F(ContactTokensTest, WithoutContactsThereIsNothing) {
  for (Tensor* rows : {&contacts_.scene, &contacts_.object, &contacts_.partner, &contacts_.point,
                       &contacts_.partner_point, &contacts_.normal, &contacts_.fraction, &contacts_.gap}) {
    *rows = rows->slice(0, 0, 0);
  }
  ContactTokens tokens(token_options());
  tokens->to(torch::kFloat64);
  const ContactDescription described = describe();
  const Tensor objects = torch::randn({1, 2, token_options().embedding_dim}, kDouble);
  const Tensor answer = tokens->answer(tokens->embed(described), described, objects);
  ASSERT_EQ(answer.sizes(), (std::vector<std::int64_t>{1, 2, 4, 6}));
  EXPECT_EQ(answer.abs().max().item<double>(), 0.0);
}

TEST_F(ContactTokensTest, GradientsAreThoseOfTheFormula) {
  approach();
  Tensor previous = scene_.state.previous.translation.clone().set_requires_grad(true);
  const auto answers = [&] {
    scene_.state.previous.translation = previous;
    const ContactDescription described = describe();
    return torch::cat(
        {described.answers.linear.flatten(), described.answers.angular.flatten(), described.features.flatten()});
  };
  EXPECT_LT(gradient_error(answers, {previous}), 1e-4);
}

}  // namespace
}  // namespace rigidformer
