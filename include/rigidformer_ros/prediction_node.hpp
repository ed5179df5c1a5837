// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/wall_timer.h>

#include <functional>
#include <memory>

#include "rigidformer_ros/forecast_publisher.hpp"
#include "rigidformer_ros/forecaster.hpp"
#include "rigidformer_ros/frame_transformer.hpp"
#include "rigidformer_ros/live_scene.hpp"
#include "rigidformer_ros/object_inputs.hpp"
#include "rigidformer_ros/parameters.hpp"
#include "rigidformer_ros/rejection_log.hpp"
#include "rigidformer_ros/rollout_service.hpp"

namespace rigidformer_ros {

/// The node: clouds in, forecasts out, services. Input, forecasts and services each have their own queue and thread, so
/// that none waits for another; the model has one of its own.
class PredictionNode {
 public:
  /// Starts working at once. `make_predictor` runs on the inference thread.
  PredictionNode(const NodeParameters& parameters, PredictorFactory make_predictor);
  ~PredictionNode();

  /// Ends rollouts in progress, which could take many seconds, after their current job.
  void stop() { forecaster_.stop(); }

 private:
  /// A node handle whose callbacks run one at a time on a thread of their own.
  struct Lane {
    Lane();
    ros::CallbackQueue queue;
    ros::NodeHandle node;
    ros::AsyncSpinner spinner;
  };

  void on_cloud(const ListedObject& source, const sensor_msgs::PointCloud2& cloud);
  void take_in(const ListedObject& source, const sensor_msgs::PointCloud2& cloud);
  void on_forecast_timer();
  void forecast_newest_scene();
  void on_report_timer();

  NodeParameters parameters_;
  RejectionLog rejections_;
  FrameTransformer frames_;
  LiveScene live_scene_;
  Forecaster forecaster_;
  Lane input_lane_;
  Lane forecast_lane_;
  Lane service_lane_;
  ForecastPublisher publisher_;
  RolloutService service_;
  ObjectInputs inputs_;
  ros::Time last_forecast_stamp_;
  std::size_t last_forecast_size_ = 0;
  bool reported_ready_ = false;
  ros::WallTimer forecast_timer_;
  ros::WallTimer report_timer_;
};

/// Makes the predictor that the options describe.
using ModelLoader = std::function<std::unique_ptr<rigidformer::Predictor>(const rigidformer::PredictorOptions&)>;

/// Loads a checkpoint. A file package://NAME/PATH lies in the ROS package NAME. Throws as Predictor does.
std::unique_ptr<rigidformer::Predictor> load_model(const rigidformer::PredictorOptions& options);

/// Reads the private parameters, builds the node and spins until shutdown. Returns the exit code: 1 for parameters that
/// cannot work.
int run_prediction_node(const ModelLoader& make_predictor = load_model);

}  // namespace rigidformer_ros
