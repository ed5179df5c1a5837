// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "still_scene.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "rigidformer_ros/node/prediction_node.hpp"
#include "rigidformer_ros/simulated/accuracy/tracking_accuracy.hpp"
#include "test_data.hpp"

namespace {

constexpr int kClouds = 40;  // 8 s
// Of the forecasts. Fragments that the segmentation finds now and then fall (docs/reliability.md).
constexpr double kMinShare = 0.75, kMinOkShare = 0.95;

std::unique_ptr<rigidformer_ros::SceneForecaster> load(rigidformer_ros::NodeParameters& parameters) {
  parameters.correspondence.method = rigidformer::Correspondence::kRegistration;
  parameters.predict.length_scale.reset();
  parameters.model.file = RIGIDFORMER_SOURCE_DIR "/models/hybrid.safetensors";
  return rigidformer_ros::camera::make_ready_forecaster(parameters, rigidformer_ros::load_model(parameters.model));
}

TEST(StillSceneTest, P59_WhatStandsOnRealTablesIsForecastToStand) {
  const std::filesystem::path folder = rigidformer::published_data() / "table_scenes";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there (RIGIDFORMER_TEST_DATA)";
  rigidformer_ros::NodeParameters parameters;
  const auto forecaster = load(parameters);
  StillOptions options;
  options.num_clouds = kClouds;
  const SegmentationOptions segmentation;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".pcd") continue;
    const StillScene scene = read_still_scene(entry.path().string(), segmentation);
    const StillReport report = play_still_scene(scene, options, segmentation, parameters, *forecaster);
    EXPECT_EQ(report.num_forecasts, kClouds);
    EXPECT_GE(report.objects.size(), 2U) << entry.path();
    EXPECT_GE(report.num_still, kMinShare * kClouds) << entry.path() << '\n' << still_table(report);
    EXPECT_GE(report.num_ok_still, kMinOkShare * kClouds) << entry.path() << '\n' << still_table(report);
  }
}

TEST(StillSceneTest, AFileThatIsNoCloudIsNamed) {
  try {
    read_still_scene(RIGIDFORMER_SOURCE_DIR "/package.xml", {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("package.xml"), std::string::npos);
  }
}

}  // namespace
