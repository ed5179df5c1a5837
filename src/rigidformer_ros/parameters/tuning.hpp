// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <memory>

#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

/// Lets dynamic_reconfigure change parameters that only tune the running node: predict/rate, predict/num_steps, display
/// and the limits in diagnostics, each group under its own name. Values out of range are clamped, others that the node
/// cannot take are refused with a warning.
class TuningServer {
 public:
  /// All parameters with the change in place.
  using Apply = std::function<void(const NodeParameters& parameters)>;

  /// Starts from `parameters`. `apply` runs on the callback queue of `private_node`, and once per group from here.
  TuningServer(const ros::NodeHandle& private_node, const NodeParameters& parameters, Apply apply);
  ~TuningServer();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rigidformer_ros
