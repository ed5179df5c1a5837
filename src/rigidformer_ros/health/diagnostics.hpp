// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <cstdint>
#include <map>
#include <string>

#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/health/forecast_check.hpp"
#include "rigidformer_ros/health/input_monitor.hpp"
#include "rigidformer_ros/health/rejection_log.hpp"
#include "rigidformer_ros/health/shared_value.hpp"
#include "rigidformer_ros/health/timing_monitor.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

/// Publishes the node's health on /diagnostics: model, input, tf, timing, forecast quality. It only reads values that
/// the other threads left for it, so that it goes on reporting while one of them hangs.
class NodeDiagnostics {
 public:
  /// The objects that the diagnostics report about. They must outlive the diagnostics.
  struct Sources {
    const SceneForecaster& forecaster;
    const RejectionLog& rejections;
    InputMonitor& input;
    TimingMonitor& timing;
    const SharedValue<ForecastQuality>& quality;
  };

  /// Publishes every `diagnostics/period` seconds of wall time, on the callback queue of `node`.
  NodeDiagnostics(ros::NodeHandle& node, const ros::NodeHandle& private_node, const DiagnosticsParameters& parameters,
                  const Sources& sources);

  /// Changes the limits, from the next message on. This may be called from any thread.
  void tune(const DiagnosticsParameters& parameters) { limits_.set(parameters); }

 private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void update();
  void report_model(Status& status);
  void report_input(Status& status);
  void report_tf(Status& status);
  void report_timing(Status& status);
  void report_quality(Status& status);
  std::uint64_t rejected_since_last_update(const std::string& reason) const;

  Sources sources_;
  SharedValue<DiagnosticsParameters> limits_;
  std::map<std::string, RejectionLog::Count> rejections_;         ///< All rejections up to this update
  std::map<std::string, RejectionLog::Count> rejections_before_;  ///< All rejections up to the update before it
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace rigidformer_ros
