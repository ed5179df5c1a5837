// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "euclidean_segmentation.hpp"
#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer_ros/forecast/scene_forecaster.hpp"

/// One cloud of a camera before a table on which nothing moves.
struct StillScene {
  rigidformer::Points points_camera;           ///< [N, 3] m; NaN = nothing was measured
  std::vector<std::uint32_t> labels;           ///< [N]; 0 = no object. Empty = the cloud has none
  rigidformer::RigidTransform T_world_camera;  ///< The table is the plane z = 0
};

/// Reads a PCD file with or without labels; label 1 is the table. Throws std::runtime_error naming the file where it is
/// no cloud, or shows no table.
StillScene read_still_scene(const std::string& file, const SegmentationOptions& options);

/// How a still scene is played, and what counts as standing still.
struct StillOptions {
  double rate_hz = 5.0;
  int num_clouds = 100;
  double noise_m = 0.001;  ///< Standard deviation along the rays
  double horizon_s = 0.5;
  double still_m = 0.005;
  double still_rad = 2.0 * 3.14159265358979 / 180.0;
  bool use_labels = false;  ///< Of the file, instead of the segmentation
  std::uint32_t seed = 1;
};

/// What was forecast of one object.
struct StillObject {
  int num_forecasts = 0;
  int num_moved = 0;                          ///< Forecasts in which it does not stand still
  std::map<std::uint8_t, int> num_of_status;  ///< Forecasts by ObjectForecast's status
  std::vector<double> moved_m, turned_rad;    ///< The farthest within each forecast
};

/// What was forecast of a scene.
struct StillReport {
  int num_forecasts = 0;
  int num_still = 0;     ///< Forecasts in which everything stands still
  int num_ok_still = 0;  ///< Forecasts in which all objects with status OK do
  std::map<std::string, StillObject> objects;
};

/// Publishes the scene to the classes that the node uses, again and again with other noise, and forecasts every cloud.
StillReport play_still_scene(const StillScene& scene, const StillOptions& options,
                             const SegmentationOptions& segmentation, const rigidformer_ros::NodeParameters& parameters,
                             rigidformer_ros::SceneForecaster& forecaster);

/// The report as a table with a row per object.
std::string still_table(const StillReport& report);
