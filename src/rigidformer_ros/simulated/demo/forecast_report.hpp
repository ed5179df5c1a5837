// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>
#include <vector>

#include "rigidformer_ros/simulated/demo/forecast_comparison.hpp"

namespace rigidformer_ros::demo {

/// Listens to one scene of the demo publisher and to the forecasts made of it, and compares them with what happened.
class ForecastReport {
 public:
  explicit ForecastReport(ros::NodeHandle& node);

  /// Listens until one scene is over. Returns false when that has not happened after `timeout_s` seconds of wall time.
  bool listen(double timeout_s);

  /// Says what has been missing, after listen() returned false.
  std::string missing() const;

  /// The report: a table of one forecast, made about half a second into the scene, and the mean errors of all
  /// forecasts.
  std::string text() const;

 private:
  void on_truth(const SceneForecast& truth);
  void on_forecast(const SceneForecast& forecast);

  std::string table() const;
  std::string mean_errors() const;

  ros::Subscriber truth_subscriber_, forecast_subscriber_;
  SceneForecast truth_;
  std::vector<SceneForecast> forecasts_;  // The forecasts made of the scene truth_
  bool has_truth_ = false, scene_over_ = false;
};

}  // namespace rigidformer_ros::demo
