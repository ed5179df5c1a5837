// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/SceneForecast.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace rigidformer_ros::demo {

/// One object at one horizon, positions [m] in the fixed frame.
struct Comparison {
  std::string id;
  double horizon_s = 0.0;
  Eigen::Vector3d predicted;
  Eigen::Vector3d actual;
  Eigen::Vector3d ballistic;  ///< Guess without contacts: the true velocity at t0 and gravity

  double error_m() const { return (predicted - actual).norm(); }
  double ballistic_error_m() const { return (ballistic - actual).norm(); }
};

/// Position of `motion` at `time` [s] from the forecast's stamp, linear between the given times; empty outside them.
std::optional<Eigen::Vector3d> position_at(const std::vector<double>& times, const ObjectForecast& motion, double time);

/// Compares a forecast with the true motion at every horizon that both cover, for objects known to both.
std::vector<Comparison> compare(const SceneForecast& forecast, const SceneForecast& truth,
                                const std::vector<double>& horizons_s, double gravity = -10.0);

}  // namespace rigidformer_ros::demo
