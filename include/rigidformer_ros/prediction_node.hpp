// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/wall_timer.h>

#include <functional>
#include <memory>

#include "rigidformer_ros/diagnostics.hpp"
#include "rigidformer_ros/forecast_check.hpp"
#include "rigidformer_ros/forecast_loop.hpp"
#include "rigidformer_ros/forecaster.hpp"
#include "rigidformer_ros/frame_transformer.hpp"
#include "rigidformer_ros/input_monitor.hpp"
#include "rigidformer_ros/live_scene.hpp"
#include "rigidformer_ros/object_inputs.hpp"
#include "rigidformer_ros/parameters.hpp"
#include "rigidformer_ros/rejection_log.hpp"
#include "rigidformer_ros/rollout_service.hpp"
#include "rigidformer_ros/scene_inputs.hpp"
#include "rigidformer_ros/scene_intake.hpp"
#include "rigidformer_ros/shared_value.hpp"
#include "rigidformer_ros/timing_monitor.hpp"
#include "rigidformer_ros/tuning.hpp"

namespace rigidformer_ros {

/// The node: clouds in, forecasts out, services. Input, forecasts, services and diagnostics each have their own queue
/// and threads, so that none waits for another; the model has one of its own. The same class serves as node and
/// nodelet.
class PredictionNode {
 public:
  /// Starts working at once. Topics and services are relative to `node`, parameters to `private_node`. `make_predictor`
  /// runs on the inference thread.
  PredictionNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const NodeParameters& parameters,
                 PredictorFactory make_predictor);
  ~PredictionNode();

  /// Ends rollouts in progress, which could take many seconds, after their current job.
  void stop() { forecaster_.stop(); }

 private:
  /// A node handle whose callbacks run on threads of their own: with one of them, one at a time.
  struct Lane {
    explicit Lane(const ros::NodeHandle& parent, std::uint32_t num_threads = 1);
    ros::CallbackQueue queue;
    ros::NodeHandle node;
    ros::AsyncSpinner spinner;
  };

  void on_report_timer();
  void tune(const NodeParameters& parameters);

  NodeParameters parameters_;
  RejectionLog rejections_;
  InputMonitor input_monitor_;
  TimingMonitor timing_;
  SharedValue<ForecastQuality> quality_;
  FrameTransformer frames_;
  LiveScene live_scene_;
  SceneIntake intake_;
  Forecaster forecaster_;
  Lane input_lane_;
  Lane forecast_lane_;
  Lane service_lane_;
  Lane health_lane_;
  ForecastLoop forecast_loop_;
  RolloutService service_;
  ObjectInputs inputs_;
  SceneInputs scene_inputs_;
  NodeDiagnostics diagnostics_;
  std::unique_ptr<TuningServer> tuning_;
  ros::WallTimer report_timer_;
};

/// Makes the predictor that the options describe.
using ModelLoader = std::function<std::unique_ptr<rigidformer::Predictor>(const rigidformer::PredictorOptions&)>;

/// Loads a checkpoint. A file package://NAME/PATH lies in the ROS package NAME. Throws as Predictor does.
std::unique_ptr<rigidformer::Predictor> load_model(const rigidformer::PredictorOptions& options);

/// Reads the private parameters and builds the node. Throws std::invalid_argument for parameters that cannot work.
std::unique_ptr<PredictionNode> make_prediction_node(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                                     const ModelLoader& make_predictor = load_model);

/// Builds the node and spins until shutdown. Returns the exit code: 1 for parameters that cannot work.
int run_prediction_node(const ModelLoader& make_predictor = load_model);

}  // namespace rigidformer_ros
