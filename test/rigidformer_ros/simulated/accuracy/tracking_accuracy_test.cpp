// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/accuracy/tracking_accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "rigidformer_ros/ballistic_predictor.hpp"

namespace rigidformer_ros::camera {
namespace {

AccuracyOptions small_options(std::vector<std::string> methods) {
  AccuracyOptions options;
  options.methods = std::move(methods);
  options.camera.seed = 31;
  options.camera.num_scenes = 1;
  options.camera.duration = 0.8;
  options.camera.width = 240;
  options.camera.height = 180;
  options.camera.dropout = options.camera.mislabelled = 0.0;
  return options;
}

TEST(Errors, MeanAndQuantiles) {
  const Errors errors{{4.0, 1.0, 3.0, 2.0, 10.0}};
  EXPECT_EQ(errors.mean(), 4.0);
  EXPECT_EQ(errors.quantile(0.0), 1.0);
  EXPECT_EQ(errors.quantile(0.5), 3.0);
  EXPECT_EQ(errors.quantile(1.0), 10.0);
  EXPECT_EQ(Errors().mean(), 0.0);
  EXPECT_EQ(Errors().quantile(0.5), 0.0);
}

// The clouds are whole surfaces in the same order, and the objects fall freely at first, as the predictor assumes: the
// measured errors must be almost zero.
TEST(TrackingAccuracy, OrderedCloudsAreTrackedExactly) {
  const NodeParameters parameters;
  const auto forecaster = make_ready_forecaster(parameters, std::make_unique<rigidformer::BallisticPredictor>());
  AccuracyOptions options = small_options({"ordered"});
  options.min_visible = 0.3;
  options.forecast_interval_s = 0.1;
  options.horizons_s = {0.125};
  const MethodAccuracy ordered = measure_accuracy(options, parameters, *forecaster).at(0);
  ASSERT_GT(ordered.position_m.values.size(), 20U);
  EXPECT_LT(ordered.position_m.quantile(1.0), 1e-4);
  EXPECT_LT(ordered.rotation_rad.quantile(1.0), 1e-3);
  EXPECT_EQ(ordered.within_target, 1.0);
  ASSERT_GT(ordered.forecast_m.at(0).values.size(), 10U);
  EXPECT_LT(ordered.forecast_m[0].quantile(0.5), 0.02);
}

// This test watches one scene. scripts/tracking_accuracy.sh makes the full measurement over ten scenes.
TEST(TrackingAccuracy, RegistrationKeepsUpWithTruePoses) {
  NodeParameters parameters;
  parameters.model.file = std::string(RIGIDFORMER_SOURCE_DIR) + "/models/hybrid.safetensors";
  parameters.model.warmup_runs = 0;
  if (!std::filesystem::exists(parameters.model.file)) {
    GTEST_SKIP() << "no weights";
  }
  AccuracyOptions options = small_options({"registration", "pose"});
  options.camera = CameraOptions();
  options.camera.seed = 32;
  options.camera.duration = 1.0;
  options.min_visible = 0.3;
  const auto forecaster = make_ready_forecaster(parameters, std::make_unique<rigidformer::Predictor>(parameters.model));
  const std::vector<MethodAccuracy> methods = measure_accuracy(options, parameters, *forecaster);
  std::cout << accuracy_table(methods, options);
  ASSERT_GT(methods[0].position_m.values.size(), 20U);
  EXPECT_LT(methods[0].position_m.quantile(0.5), 0.01);
  EXPECT_LT(methods[0].rotation_rad.quantile(0.5), 3.0 * M_PI / 180.0);
  EXPECT_LT(methods[1].position_m.quantile(1.0), 1e-6);
  // The first horizon, a quarter of a second, has an absolute bound: these objects fly freely for so long, and from
  // true poses they are predicted exactly, so that a factor of that error makes no sense.
  EXPECT_LT(methods[0].forecast_m.at(0).mean(), 0.05);
  EXPECT_LT(methods[0].forecast_m.at(1).mean(), 2.0 * methods[1].forecast_m.at(1).mean());
}

TEST(TrackingAccuracy, TheTableNamesEveryMethod) {
  AccuracyOptions options = small_options({"ordered", "pose"});
  std::vector<MethodAccuracy> methods(2);
  methods[0].method = "ordered";
  methods[1].method = "pose";
  for (MethodAccuracy& method : methods) {
    method.position_m.values = {0.001, 0.003};
    method.forecast_m.resize(2);
    method.forecast_seen_m.resize(2);
  }
  const std::string table = accuracy_table(methods, options);
  EXPECT_NE(table.find("ordered"), std::string::npos);
  EXPECT_NE(table.find("pose"), std::string::npos);
  EXPECT_NE(table.find("2.00"), std::string::npos) << "mean position in millimetres:\n" << table;
}

}  // namespace
}  // namespace rigidformer_ros::camera
