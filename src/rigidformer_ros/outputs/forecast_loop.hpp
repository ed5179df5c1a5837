// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <cstdint>

#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/health/forecast_check.hpp"
#include "rigidformer_ros/health/input_monitor.hpp"
#include "rigidformer_ros/health/rejection_log.hpp"
#include "rigidformer_ros/health/shared_value.hpp"
#include "rigidformer_ros/health/timing_monitor.hpp"
#include "rigidformer_ros/inputs/live_scene.hpp"
#include "rigidformer_ros/outputs/forecast_publisher.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

/// Publishes a forecast of every new scene, and compares the forecasts with what is then observed.
class ForecastLoop {
 public:
  /// What the loop works on; must outlive it.
  struct Context {
    LiveScene& live_scene;
    SceneForecaster& forecaster;
    RejectionLog& rejections;
    InputMonitor& input;
    TimingMonitor& timing;
    SharedValue<ForecastQuality>& quality;  ///< Written here
  };

  /// Works on the callback queue of `node`, at most `predict.rate` times per second of wall time.
  ForecastLoop(ros::NodeHandle& node, const NodeParameters& parameters, const Context& context);

  /// predict.rate, display and diagnostics take effect before the next forecast. May be called from any thread.
  void tune(const NodeParameters& parameters) { tuned_.set(parameters); }

 private:
  void on_timer();
  void take_over_tuning();
  void start_over();
  void check_forecasts();
  void report_ready_once();
  void forecast_newest_scene();
  bool is_new(const ObservedScene& scene);
  void forecast(ObservedScene scene);

  Context context_;
  SharedValue<NodeParameters> tuned_;
  NodeParameters parameters_;
  ForecastPublisher publisher_;
  ForecastCheck check_;
  std::uint64_t epoch_ = 0;  ///< Of the live scene
  rigidformer::Stamp last_stamp_;
  std::size_t last_size_ = 0;
  bool reported_ready_ = false;
  ros::WallTimer timer_;
};

}  // namespace rigidformer_ros
