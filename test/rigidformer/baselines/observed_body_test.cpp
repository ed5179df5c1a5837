// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/observed_body.hpp"

#include <gtest/gtest.h>

#include "rigidformer/baselines/engine_scenes.hpp"
#include "rigidformer/scene/mean_material.hpp"

namespace rigidformer {
namespace {

ObservedBody observe_one(const ObjectState& object, const RolloutOptions& rollout) {
  return observe_bodies({object}, rollout).at(0);
}

TEST(ObservedBody, CentreOfMassIsThatOfTheHullAndNotOfTheFrame) {
  const Eigen::Vector3d centre(0.5, -0.25, 2.0);
  Points points = box_cloud({0.5, 1.0, 0.25}, centre);
  // More points on one face move the mean of the points, but not the hull.
  points.conservativeResize(9, 3);
  points.row(8) = points.row(0);
  const ObservedBody body = observe_one(resting_object(points, {0, 0, 3}), rollout_of(1, 1));
  EXPECT_LT((body.T_reference_body.translation - centre).norm(), 1e-6);
  EXPECT_LT((body.state.T_world_object.translation - (centre + Eigen::Vector3d(0, 0, 3))).norm(), 1e-6);
  EXPECT_LT(body.parts.at(0).vertices.colwise().mean().norm(), 1e-6);
}

TEST(ObservedBody, CentroidOfACone) {
  Points pyramid(5, 3);
  pyramid << 1, 1, 0, -1, 1, 0, -1, -1, 0, 1, -1, 0, 0, 0, 2;
  const ObservedBody body = observe_one(resting_object(pyramid, {0, 0, 5}), rollout_of(1, 1));
  EXPECT_LT((body.T_reference_body.translation - Eigen::Vector3d(0.0, 0.0, 0.5)).norm(), 1e-6);  // a quarter up
}

TEST(ObservedBody, UnknownMaterialIsTheMeanOfTheScenes) {
  ObjectState object = resting_object(box_cloud({0.5, 1.0, 0.2}), {0, 0, 3});
  const BodyProperties assumed = observe_one(object, rollout_of(1, 1)).properties;
  EXPECT_NEAR(*assumed.mass_kg, 0.1 * kMeanDensity, 1e-6);
  EXPECT_EQ(*assumed.friction, kMeanFriction);
  EXPECT_EQ(*assumed.restitution, kMeanRestitution);
  object.properties = {{2.0}, {0.1}, {0.9}};
  const BodyProperties known = observe_one(object, rollout_of(1, 1)).properties;
  EXPECT_EQ(*known.mass_kg, 2.0);
  EXPECT_EQ(*known.friction, 0.1);
  EXPECT_EQ(*known.restitution, 0.9);
}

TEST(ObservedBody, VelocityAndSpinAtTheLaterPose) {
  const RolloutOptions rollout = rollout_of(10, 1);
  const Flight flight{{0.0, 0.0, 6.0}, {1.0, 2.0, -0.5}, {3.0, -4.0, 1.0}};
  const ObservedBody body = observe_one(flying_object(box_cloud({0.5, 0.5, 0.5}), flight, rollout), rollout);
  EXPECT_LT((body.state.velocity - flight.velocity).norm(), 1e-6);
  EXPECT_LT((body.state.angular_velocity - flight.spin).norm(), 1e-6);
}

TEST(ObservedBody, SpinTakesTheShortWayForBothSignsOfTheQuaternion) {
  const RolloutOptions rollout = rollout_of(10, 1);
  const Flight flight{{0.0, 0.0, 6.0}, Eigen::Vector3d::Zero(), {0.0, 0.0, 2.0}};
  ObjectState object = flying_object(box_cloud({0.5, 0.5, 0.5}), flight, rollout);
  object.T_world_current.rotation.coeffs() *= -1.0;
  EXPECT_LT((observe_one(object, rollout).state.angular_velocity - flight.spin).norm(), 1e-6);
}

TEST(ObservedBody, NothingFallsThatTouchesTheFloorInBothPoses) {
  const RolloutOptions rollout = rollout_of(10, 1);
  const Points cube = box_cloud({0.6, 0.6, 0.6});
  EXPECT_EQ(observe_one(resting_object(cube, {0, 0, 0.3}), rollout).state.velocity.z(), 0.0);
  EXPECT_NEAR(observe_one(resting_object(cube, {0, 0, 0.4}), rollout).state.velocity.z(), -10.0 * 5.0 / 240.0, 1e-9);
}

TEST(ObservedBody, FlatCloudsGetOneCentimetre) {
  const ObservedBody body = observe_one(resting_object(box_cloud({0.5, 0.0, 0.4}), {0, 0, 3}), rollout_of(1, 1));
  const Eigen::RowVector3f size =
      body.parts.at(0).vertices.colwise().maxCoeff() - body.parts.at(0).vertices.colwise().minCoeff();
  EXPECT_LT((size - Eigen::RowVector3f(0.5F, 0.01F, 0.4F)).norm(), 1e-5F);
}

TEST(ObservedBody, PosesComeBackInTheWorldOfTheReferenceFrame) {
  RolloutOptions rollout = rollout_of(10, 1);
  rollout.ground_height_m = 1.5;
  const Flight flight{{1.0, 2.0, 6.0}, {1.0, 2.0, -0.5}, {3.0, -4.0, 1.0}};
  const ObjectState object = flying_object(box_cloud({0.5, 0.4, 0.3}, {0.1, 0.2, 0.3}), flight, rollout);
  const ObservedBody body = observe_one(object, rollout);
  const double height = (object.T_world_current * Eigen::Vector3d(0.1, 0.2, 0.3)).z() - 1.5;
  EXPECT_NEAR(body.state.T_world_object.translation.z(), height, 1e-4);  // float points, solid angles of the hull
  const RigidTransform back = reference_pose(body, body.state.T_world_object, rollout);
  EXPECT_LT((back.translation - object.T_world_current.translation).norm(), 1e-9);
  EXPECT_LT(rotation_angle(back.rotation, object.T_world_current.rotation), 1e-6);
}

}  // namespace
}  // namespace rigidformer
