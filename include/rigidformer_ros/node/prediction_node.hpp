// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <memory>

#include "rigidformer/predictor.hpp"

namespace rigidformer_ros {

/// Makes the predictor that the options describe.
using ModelLoader = std::function<std::unique_ptr<rigidformer::Predictor>(const rigidformer::PredictorOptions&)>;

/// Loads a checkpoint. A file package://NAME/PATH lies in the ROS package NAME. Throws as Predictor does.
std::unique_ptr<rigidformer::Predictor> load_model(const rigidformer::PredictorOptions& options);

/// The node: clouds in, forecasts out, services. Input, forecasts, services and diagnostics each have their own queue
/// and threads, so that none waits for another; the model has one of its own. The same class serves as node and
/// nodelet.
class PredictionNode {
 public:
  /// Reads the private parameters and starts working at once. Topics and services are relative to `node`, parameters to
  /// `private_node`. `make_predictor` runs on the inference thread. Throws std::invalid_argument for parameters that
  /// cannot work, naming parameter and accepted values.
  PredictionNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                 const ModelLoader& make_predictor = load_model);
  ~PredictionNode();

  /// Ends rollouts in progress, which could take many seconds, after their current job.
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Builds the node and spins until shutdown. Returns the exit code: 1 for parameters that cannot work.
int run_prediction_node(const ModelLoader& make_predictor = load_model);

}  // namespace rigidformer_ros
