// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/contact_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "rigidformer/engine/cubes.hpp"
#include "rigidformer/model/contact_tokens.hpp"
#include "rigidformer/scene/mean_material.hpp"

namespace rigidformer {
namespace {

/// The contacts of one step of free motion.
Contacts contacts_of(const Cubes& scene) {
  const BaseMotion base = make_base_motion(token_options(), scene.batch, scene.state, scene.centre);
  return make_contact_search(token_options(), scene.batch, scene.centre)(scene.state.current, base.pose);
}

/// Two cubes without gravity, face to face along x with a given gap, the second one coming.
Cubes approaching(double gap_m, double speed_mps) {
  Cubes scene(2);
  scene.batch.gravity.zero_();
  scene.place(0, {0.0, 0.0, 3.0}, {0.0, 0.0, 0.0});
  scene.place(1, {1.0 + gap_m, 0.0, 3.0}, {-speed_mps, 0.0, 0.0});
  return scene;
}

Eigen::Vector3d row(const Tensor& rows, std::int64_t i) {
  const Tensor r = rows[i].to(torch::kFloat64);
  return {r[0].item<double>(), r[1].item<double>(), r[2].item<double>()};
}

TEST(ContactSearch, ModelsWithoutContactTokensHaveNone) {
  EXPECT_FALSE(make_contact_search(model_preset("tiny"), Cubes(1).batch, Cubes(1).centre));
}

TEST(ContactSearch, TheSideThatIsGuessedMeetsOthers) {
  Cubes scene = approaching(0.35, 4.8);
  scene.batch.points_reference[0][0].select(1, 0).fill_(-0.5);  // only the far face of the first cube is seen
  scene.batch.hidden_points = scene.batch.points_reference.clone();
  scene.batch.hidden_points[0][0].select(1, 0).fill_(0.8);
  const Contacts contacts = contacts_of(scene);
  ASSERT_EQ(contacts.count(), 2);
  EXPECT_NEAR(contacts.fraction[0].item<double>(), 0.25, 0.006) << "0.05 m of 0.2 m";
}

TEST(ContactSearch, TellsBothSidesWhenAndWhereTheyMeet) {
  const double speed_mps = 4.8;  // 0.2 m during a step of 10 frames
  const Contacts contacts = contacts_of(approaching(0.05, speed_mps));
  ASSERT_EQ(contacts.count(), 2);
  for (std::int64_t i = 0; i < 2; ++i) {
    const auto k = contacts.object[i].item<std::int64_t>();
    const double side = k == 0 ? 1.0 : -1.0;  // of the contact, seen from the cube
    EXPECT_EQ(contacts.partner[i].item<std::int64_t>(), 1 - k);
    EXPECT_NEAR(contacts.fraction[i].item<double>(), 0.25, 0.006);  // 1 mm of 0.2 m is its margin
    EXPECT_NEAR(contacts.gap[i].item<double>(), 0.0, 0.0011);
    EXPECT_NEAR(row(contacts.point, i).x(), side * 0.5, 1e-3);
    EXPECT_NEAR(row(contacts.partner_point, i).x(), -side * 0.5, 1e-3);
    EXPECT_LT((row(contacts.normal, i) - Eigen::Vector3d(-side, 0.0, 0.0)).norm(), 1e-3);
  }
}

TEST(ContactSearch, WhatComesNearIsToldAtTheEndOfTheStep) {
  const Contacts contacts = contacts_of(approaching(0.23, 4.8));
  ASSERT_EQ(contacts.count(), 2);
  EXPECT_EQ(contacts.fraction.min().item<double>(), 1.0);
  EXPECT_NEAR(contacts.gap[0].item<double>(), 0.03, 1e-4);
}

TEST(ContactSearch, WhatStaysApartOrGoesApartIsNot) {
  EXPECT_EQ(contacts_of(approaching(0.3, 4.8)).count(), 0);
  EXPECT_EQ(contacts_of(approaching(0.02, -4.8)).count(), 0);
}

TEST(ContactSearch, AFastBodyDoesNotTunnel) {
  const Contacts contacts = contacts_of(approaching(1.0, 240.0));  // 10 m during the step
  ASSERT_GE(contacts.count(), 2);
  EXPECT_NEAR(contacts.fraction.min().item<double>(), 0.1, 1e-3);
}

TEST(ContactSearch, ASpinningBodyIsMetByItsCorner) {
  Cubes scene = approaching(0.1, 0.0);  // nearer than the corner's circle of radius 0.71
  const double turn = 0.25 * M_PI;      // until the corner stands out
  scene.state.previous.rotation = scene.state.current.rotation.clone();
  scene.state.previous.rotation[0][1] =
      torch::tensor({std::cos(turn), std::sin(turn), 0.0, -std::sin(turn), std::cos(turn), 0.0, 0.0, 0.0, 1.0},
                    torch::kFloat64)
          .reshape({3, 3});
  const Contacts contacts = contacts_of(scene);
  ASSERT_GE(contacts.count(), 2);
  const double fraction = contacts.fraction.min().item<double>();
  // The corner that starts 0.5 m off the axis reaches x = 0.6 at the angle where sqrt(0.5) cos(45 deg - angle) = 0.6.
  const double angle = turn - std::acos(0.6 / std::sqrt(0.5));
  EXPECT_NEAR(fraction, angle / turn, 0.01);
}

TEST(ContactSearch, AFaceComesToTheGroundWithItsFourCorners) {
  Cubes scene(1);
  scene.batch.gravity.zero_();
  scene.batch.ground_height.fill_(-2.0);
  scene.place(0, {1.0, 2.0, -1.4}, {0.0, 0.0, -4.8});  // 0.1 m above the ground, 0.2 m down during the step
  const Contacts contacts = contacts_of(scene);
  ASSERT_EQ(contacts.count(), 4);
  std::set<std::pair<bool, bool>> corners;
  for (std::int64_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d point = row(contacts.point, i);
    corners.insert({point.x() > 0.0, point.y() > 0.0});
    EXPECT_NEAR(point.z(), -0.5, 1e-6);
    EXPECT_EQ(contacts.partner[i].item<std::int64_t>(), -1);
    EXPECT_NEAR(contacts.fraction[i].item<double>(), 0.5, 1e-5);
    EXPECT_NEAR(contacts.gap[i].item<double>(), 0.0, 1e-5);
    EXPECT_EQ(row(contacts.normal, i), Eigen::Vector3d::UnitZ());
  }
  EXPECT_EQ(corners.size(), 4u);
}

TEST(ContactSearch, WithoutGroundOrHighAboveItNothingIsMet) {
  Cubes scene(1);
  scene.place(0, {0.0, 0.0, 5.0}, {0.0, 0.0, 0.0});
  EXPECT_EQ(contacts_of(scene).count(), 0);
  scene.place(0, {0.0, 0.0, 0.5}, {0.0, 0.0, 0.0});
  EXPECT_EQ(contacts_of(scene).count(), 4);
  scene.batch.ground_height.fill_(kNoGround);
  EXPECT_EQ(contacts_of(scene).count(), 0);
}

TEST(ContactSearch, GivenMotionIsMetButNotTold) {
  Cubes scene = approaching(0.05, 4.8);
  scene.batch.dynamic_mask[0][1] = false;
  const Contacts contacts = contacts_of(scene);
  ASSERT_EQ(contacts.count(), 1);
  EXPECT_EQ(contacts.object[0].item<std::int64_t>(), 0);
}

TEST(ContactSearch, ALostBodyMeetsNothingAndHidesNothing) {
  Cubes scene(3);
  scene.batch.gravity.zero_();
  scene.place(0, {0.0, 0.0, 3.0}, {0.0, 0.0, 0.0});
  scene.place(1, {1.05, 0.0, 3.0}, {-4.8, 0.0, 0.0});
  scene.place(2, {0.0, 1.0, 3.0}, {0.0, 0.0, 0.0});
  scene.state.current.translation[0][2][1] = std::nan("");
  EXPECT_EQ(contacts_of(scene).count(), 2);
  scene.place(2, {0.0, 1.0, 3.0}, {1e9, 0.0, -1e9});
  for (const Tensor& rows : {contacts_of(scene).point, contacts_of(scene).normal, contacts_of(scene).gap}) {
    EXPECT_TRUE(torch::isfinite(rows).all().item<bool>());
  }
}

TEST(ContactSearch, BodiesAreDescribed) {
  Cubes scene(2);
  scene.place(0, {0.0, 0.0, 5.0}, {0.0, 0.0, 0.0});
  scene.place(1, {3.0, 0.0, 5.0}, {0.0, 0.0, 0.0});
  scene.batch.properties[0][0][0] = 3.0;
  scene.batch.properties_known[0][1][0] = 0.0;
  const Contacts contacts = contacts_of(scene);
  EXPECT_NEAR(contacts.mass[0][0].item<double>(), 3.0, 1e-12);
  EXPECT_NEAR(contacts.mass[0][1].item<double>(), kMeanDensity, 1e-3) << "of one cubic metre";
  EXPECT_LT(largest_difference(contacts.inverse_inertia[0][0], 6.0 * torch::eye(3, torch::kFloat64)), 1e-4);
}

TEST(ContactSearch, BatchAndOneByOneAgree) {
  const Cubes first = approaching(0.05, 4.8), second = approaching(0.1, 4.8);
  Cubes both = first;
  for (Tensor SceneBatch::*tensor : kBatchTensors) {
    if ((first.batch.*tensor).defined()) both.batch.*tensor = torch::cat({first.batch.*tensor, second.batch.*tensor});
  }
  both.centre = torch::cat({first.centre, second.centre});
  for (Pose SceneState::*pose : {&SceneState::first, &SceneState::previous, &SceneState::current}) {
    both.state.*pose = {torch::cat({(first.state.*pose).rotation, (second.state.*pose).rotation}),
                        torch::cat({(first.state.*pose).translation, (second.state.*pose).translation})};
  }
  const Contacts all = contacts_of(both), alone = contacts_of(second);
  ASSERT_EQ(all.count(), 4);
  EXPECT_TRUE(torch::equal(all.scene, torch::tensor({0, 0, 1, 1}, torch::kInt64)));
  EXPECT_TRUE(torch::equal(all.fraction.slice(0, 2), alone.fraction));
  EXPECT_TRUE(torch::equal(all.point.slice(0, 2), alone.point));
}

TEST(ContactSearch, P36_AnObjectWithoutAHullIsNamed) {
  Cubes scene(2);
  scene.batch.points_reference[0][1].fill_(std::nan(""));
  try {
    contacts_of(scene);
    FAIL() << "not refused";
  } catch (const BodyError& error) {
    EXPECT_EQ(error.object(), 1);
  }
}

/// The scene, turned about the vertical and moved along the ground.
Cubes moved(Cubes scene, double yaw, const Eigen::Vector3d& shift) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  const auto kind = torch::TensorOptions(torch::kFloat64);
  const Tensor R = torch::tensor({c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0}, kind).reshape({3, 3});
  const Tensor t = torch::tensor({shift.x(), shift.y(), shift.z()}, kind);
  for (Pose* pose : {&scene.state.first, &scene.state.previous, &scene.state.current}) {
    *pose = {torch::matmul(R, pose->rotation), torch::matmul(pose->translation, R.t()) + t};
  }
  return scene;
}

Cubes with_anchors(Cubes scene) {
  scene.batch.anchor_index =
      torch::tensor({0, 3, 5}, torch::kInt64).expand({1, scene.batch.max_objects(), 3}).contiguous();
  scene.batch.normals_reference = scene.batch.points_reference / scene.batch.points_reference.norm(2, -1, true);
  return scene;
}

TEST(ContactSearch, WhatTokensSayDoesNotDependOnWhereTheSceneStands) {
  Cubes scene = with_anchors(approaching(0.05, 4.8));
  scene.place(0, {0.1, 0.2, 0.52}, {0.3, -1.0, -2.0});
  scene.place(1, {1.3, 0.1, 0.6}, {-4.8, 0.5, -1.0});
  torch::manual_seed(2);  // tilted, so that one corner comes first
  scene.state.current.rotation =
      special_procrustes(torch::eye(3, torch::kFloat64) + 0.3 * torch::randn({1, 2, 3, 3}, torch::kFloat64));
  scene.state.previous.rotation = scene.state.current.rotation;
  const auto describe = [](const Cubes& cubes) {
    const BaseMotion base = make_base_motion(token_options(), cubes.batch, cubes.state, cubes.centre);
    return describe_contacts(token_options(), cubes.batch, cubes.state, base, contacts_of(cubes));
  };
  const ContactDescription here = describe(scene), there = describe(moved(scene, 0.7, {3.0, -2.0, 0.0}));
  ASSERT_GT(here.row.size(0), 2);
  ASSERT_EQ(there.row.size(0), here.row.size(0));
  EXPECT_LT(largest_difference(there.features, here.features), 2e-3);
  EXPECT_LT(largest_difference(there.answers.linear.norm(2, -1), here.answers.linear.norm(2, -1)), 2e-3);
}

/// A model whose contact tokens have a say.
RigidFormer token_model() {
  ModelOptions options = token_options();
  options.num_anchors = 3;
  RigidFormer model = random_model(options);
  torch::NoGradGuard no_grad;
  model->contact_tokens->share->second->bias.fill_(1.0);
  return model;
}

StepPrediction predict_cubes(RigidFormer& model, const Cubes& scene, const ContactSearch& search) {
  torch::NoGradGuard no_grad;
  return model->forward(scene.batch, scene.state, scene.centre, nearest_by_distance_matrix, {}, search);
}

TEST(ContactSearch, TheNetworkReadsAndUsesContacts) {
  RigidFormer model = token_model();
  const Cubes scene = with_anchors(approaching(0.05, 4.8));
  const ContactSearch search = make_contact_search(model->options, scene.batch, scene.centre);
  const StepPrediction prediction = predict_cubes(model, scene, search);
  const ContactSearch without = [&](const Pose& from, const Pose& to) {
    Contacts contacts = search(from, to);
    for (Tensor* rows : {&contacts.scene, &contacts.object, &contacts.partner, &contacts.point, &contacts.partner_point,
                         &contacts.normal, &contacts.fraction, &contacts.gap}) {
      *rows = rows->slice(0, 0, 0);
    }
    return contacts;
  };
  const StepPrediction blind = predict_cubes(model, scene, without);
  EXPECT_GT(largest_difference(prediction.anchors_raw, blind.anchors_raw), 0.01);
  EXPECT_THROW(predict_cubes(model, scene, {}), std::invalid_argument);
}

TEST(ContactSearch, GradientsFlowThroughTheVelocities) {
  RigidFormer model = token_model();
  Cubes scene = with_anchors(approaching(0.05, 4.8));
  scene.state.previous.translation.set_requires_grad(true);
  const ContactSearch search = make_contact_search(model->options, scene.batch, scene.centre);
  const BaseMotion base = make_base_motion(model->options, scene.batch, scene.state, scene.centre);
  const ContactDescription described =
      describe_contacts(token_options(), scene.batch, scene.state, base, search(scene.state.current, base.pose));
  described.answers.linear.square().sum().backward();
  const Tensor gradient = scene.state.previous.translation.grad();
  EXPECT_TRUE(torch::isfinite(gradient).all().item<bool>());
  EXPECT_GT(gradient.abs().max().item<double>(), 1.0);
}

}  // namespace
}  // namespace rigidformer
