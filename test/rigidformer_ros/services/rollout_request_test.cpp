// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/rollout_request.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/services/request_error.hpp"
#include "rigidformer_ros/test_scene.hpp"

namespace rigidformer_ros {
namespace {

using Request = PredictRollout::Request;
using Response = PredictRollout::Response;

ObjectClouds scene_at(double t, int num_points = 200) {
  ObjectClouds scene;
  scene.header.stamp = ros::Time(100.0 + t);
  scene.ids = {"a"};
  scene.clouds = {to_cloud(testing::Flight().pose(t).apply(testing::blob(num_points)))};
  return scene;
}

SceneSource source_of(const Request& request) { return read_task(request, NodeParameters(), RolloutSettings()).source; }

/// Data for requests; `live` counts how often the live scene is asked for.
RequestSources sources(int& live) {
  RequestSources sources;
  sources.live_scene = [&live](double time_step_s) {
    ++live;
    ObservedScene scene;
    scene.time_step_s = time_step_s;
    return scene;
  };
  sources.model_for = [](const ObservedScene&) {
    rigidformer::ModelInfo model;
    model.max_time_step_s = 1.0;
    return model;
  };
  sources.T_fixed_from = [](const std::string&, const ros::Time&) { return RigidTransform(); };
  return sources;
}

ObservedScene read(const Request& request, int& live) {
  return read_scene(request, source_of(request), NodeParameters(), 0.04, sources(live));
}

std::string rejection(const std::function<void()>& call) {
  try {
    call();
  } catch (const RequestError& error) {
    EXPECT_EQ(error.code(), Response::INVALID_REQUEST) << error.what();
    return error.what();
  }
  return "";
}

TEST(RolloutRequest, TheSourceOfTheSceneIsWhatIsFilled) {
  Request request;
  EXPECT_EQ(source_of(request), SceneSource::kLive);
  request.scene = scene_at(0.04);
  EXPECT_EQ(source_of(request), SceneSource::kGiven);
  request.previous_scene = scene_at(0.0);
  EXPECT_EQ(source_of(request), SceneSource::kGivenAndBefore);
  request.scene = ObjectClouds();
  EXPECT_NE(rejection([&] { source_of(request); }).find("previous_scene: is filled although scene is empty"),
            std::string::npos);
}

TEST(RolloutRequest, GivenScenesAreReadWithoutTheLiveOne) {
  Request request;
  int live = 0;
  request.scene = scene_at(0.04);
  EXPECT_TRUE(read(request, live).objects.at(0).assumed_static);
  request.previous_scene = scene_at(0.0);
  EXPECT_FALSE(read(request, live).objects.at(0).assumed_static);
  EXPECT_EQ(live, 0);
  EXPECT_THROW(read(Request(), live), RequestError) << "nothing has been observed";
  EXPECT_GT(live, 0);
}

TEST(RolloutRequest, CloudsOfTooFewFinitePointsAreNamed) {
  int live = 0;
  Request request;
  request.scene = scene_at(0.04, 2);
  EXPECT_NE(rejection([&] { read(request, live); }).find("scene object 'a': has 2 finite points, needs at least 4"),
            std::string::npos);
  request.scene = scene_at(0.04);
  request.previous_scene = scene_at(0.0, 3);
  EXPECT_NE(rejection([&] { read(request, live); }).find("previous_scene object 'a': has 3 finite points"),
            std::string::npos);
}

}  // namespace
}  // namespace rigidformer_ros
