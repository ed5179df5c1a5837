// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/simulated/camera/camera_options.hpp"

namespace rigidformer_ros::camera {

/// What to measure. The scenes and the camera are those of `camera`.
struct AccuracyOptions {
  CameraOptions camera;
  std::vector<std::string> methods{"ordered", "registration", "pose"};  ///< Values of correspondence.method
  double min_visible = 0.4;                                             ///< Share of the surface that must be seen
  double forecast_interval_s = 0.25;                                    ///< Between two forecasts of a scene
  std::vector<double> horizons_s{0.25, 0.5};                            ///< Multiples of the time step of predict.*
};

/// A list of errors.
struct Errors {
  std::vector<double> values;

  double mean() const;
  /// Value that the share `fraction` does not exceed; 0 for an empty list.
  double quantile(double fraction) const;
};

/// How well the node would have known and foreseen the objects with one way of correspondence.
struct MethodAccuracy {
  std::string method;
  int num_tracks = 0;                   ///< Begun, one per object and scene when none was ever lost
  Errors position_m;                    ///< Of the tracked centre of mass, objects seen well enough
  Errors rotation_rad;                  ///< Likewise; of the axis alone for bodies of revolution, none for spheres
  double within_target = 0.0;           ///< Share of those within 1 cm and 3 degrees
  std::vector<Errors> forecast_m;       ///< Per horizon, position, over what all methods forecast
  std::vector<Errors> forecast_seen_m;  ///< Likewise, objects seen well enough at t0
};

/// Plays the scenes through the classes that the node uses, once per method on the same frames: ordered gets the whole
/// surface in the same order, registration the labelled points of the camera, pose those and the true pose. Tracked
/// poses are compared from where a track begins. Throws what these classes throw.
std::vector<MethodAccuracy> measure_accuracy(const AccuracyOptions& options, const NodeParameters& parameters,
                                             SceneForecaster& forecaster);

/// A forecaster around a loaded model, warmed up. Throws std::runtime_error when that fails.
std::unique_ptr<SceneForecaster> make_ready_forecaster(const NodeParameters& parameters,
                                                       std::unique_ptr<rigidformer::Predictor> predictor);

/// The measured numbers as text, one row per method.
std::string accuracy_table(const std::vector<MethodAccuracy>& methods, const AccuracyOptions& options);

}  // namespace rigidformer_ros::camera
