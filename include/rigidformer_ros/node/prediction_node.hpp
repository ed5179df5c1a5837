// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <memory>

#include "rigidformer/predictor.hpp"

/// The ROS side of RigidFormer: the prediction node and the conversions between ROS messages and the types of the core.
namespace rigidformer_ros {

/// A function that makes the predictor that the options describe.
using ModelLoader = std::function<std::unique_ptr<rigidformer::Predictor>(const rigidformer::PredictorOptions&)>;

/// Loads a checkpoint. A file name of the form package://NAME/PATH means the file PATH of the ROS package NAME. Throws
/// std::runtime_error for a package that is not found, and what the constructor of Predictor throws.
std::unique_ptr<rigidformer::Predictor> load_model(const rigidformer::PredictorOptions& options);

/// The node as one object: it takes clouds, publishes forecasts and offers the services. Input, forecasts, services and
/// diagnostics each have a callback queue and threads of their own, so that none of them waits for another; the model
/// has a thread of its own too. The program and the nodelet both use this class.
class PredictionNode {
 public:
  /// Reads the private parameters and starts working at once. Topics and services are relative to `node`, parameters to
  /// `private_node`. `make_predictor` runs on the inference thread. Throws std::invalid_argument for parameters that
  /// cannot work, naming the parameter and the accepted values.
  PredictionNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                 const ModelLoader& make_predictor = load_model);

  /// Stops the work and waits for callbacks in progress.
  ~PredictionNode();

  /// Ends rollouts in progress after their current job, because a whole rollout can take many seconds.
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Builds the node and runs it until shutdown. Returns the exit code of the program: 1 for parameters that cannot work
/// or after a restart of the ROS master, otherwise 0.
int run_prediction_node(const ModelLoader& make_predictor = load_model);

}  // namespace rigidformer_ros
