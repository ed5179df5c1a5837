// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "rigidformer/tracking/shape_camera.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/services/request_error.hpp"
#include "rigidformer_ros/services/scene_request.hpp"

namespace rigidformer_ros {
namespace {

using rigidformer::testing::ShapeCamera;
using rigidformer::testing::Tumble;

// [s] between two clouds, as from a camera of 30 Hz.
constexpr double kFrame = 1.0 / 30.0;

RigidTransform stay(const std::string&, const ros::Time&) { return RigidTransform(); }

ObjectClouds scene_at(double t, const Points& points) {
  ObjectClouds scene;
  scene.header.stamp = ros::Time(100.0 + t);
  scene.ids = {"a"};
  scene.clouds = {to_cloud(points)};
  return scene;
}

TEST(SceneRegistration, P12_a_request_may_hold_other_points_than_the_scene_before_it) {
  ShapeCamera camera("bone", 1.0, 15);
  const Tumble tumble;
  const ObjectClouds previous = scene_at(0.0, camera.sample(tumble.pose(0.0), 1200));
  const ObjectClouds scene = scene_at(kFrame, camera.sample(tumble.pose(kFrame), 700));
  NodeParameters parameters;
  EXPECT_THROW(track_scenes(scene, &previous, parameters, stay), RequestError) << "ordered needs the same points";
  parameters.correspondence.method = rigidformer::Correspondence::kRegistration;
  const rigidformer::ObservedScene observed = track_scenes(scene, &previous, parameters, stay).snapshot(kFrame);
  ASSERT_EQ(observed.objects.size(), 1U);
  EXPECT_FALSE(observed.objects[0].assumed_static);
  EXPECT_FALSE(observed.objects[0].low_quality);
  const rigidformer::ObjectState& state = observed.objects[0].state;
  const rigidformer::testing::PoseError error = rigidformer::testing::pose_error(
      state.T_world_current, state.T_world_previous, tumble.pose(kFrame), tumble.pose(0.0));
  EXPECT_LT(error.position_m, 0.01);
  EXPECT_LT(error.rotation_rad, 2.0 * M_PI / 180.0);
}

}  // namespace
}  // namespace rigidformer_ros
