// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/SceneForecast.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace rigidformer_ros::demo {

/// Where one object was predicted to be at one horizon, and where it was. Positions [m] are in the fixed frame.
struct Comparison {
  std::string id;
  double horizon_s = 0.0;     ///< Time from the forecast on [s]
  Eigen::Vector3d predicted;  ///< Position in the forecast
  Eigen::Vector3d actual;     ///< True position
  Eigen::Vector3d ballistic;  ///< A guess without contacts: from the true velocity at the forecast and gravity

  double error_m() const { return (predicted - actual).norm(); }
  double ballistic_error_m() const { return (ballistic - actual).norm(); }
};

/// The position of `motion` at `time` [s] from the stamp of its forecast. Between the given times it is interpolated
/// linearly; outside them the result is empty.
std::optional<Eigen::Vector3d> position_at(const std::vector<double>& times, const ObjectForecast& motion, double time);

/// Compares a forecast with the true motion, for all objects that both know and at every horizon that both cover.
/// `gravity` [m/s^2] is that of the guess without contacts; -10 is what the scenes are simulated with.
std::vector<Comparison> compare(const SceneForecast& forecast, const SceneForecast& truth,
                                const std::vector<double>& horizons_s, double gravity = -10.0);

}  // namespace rigidformer_ros::demo
