// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/GetModelInfo.h>
#include <rigidformer_ros/PredictRollout.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include "rigidformer_ros/forecaster.hpp"
#include "rigidformer_ros/frame_transformer.hpp"
#include "rigidformer_ros/live_scene.hpp"
#include "rigidformer_ros/parameters.hpp"

namespace rigidformer_ros {

/// The services predict_rollout, get_model_info and reset. Handlers always return true, with failures in the answer.
class RolloutService {
 public:
  /// Handlers run on the callback queue of `node`. All references must outlive the service.
  RolloutService(ros::NodeHandle& node, const NodeParameters& parameters, Forecaster& forecaster, LiveScene& live_scene,
                 const FrameTransformer& frames);

  /// Answers one request; never throws.
  PredictRollout::Response answer(const PredictRollout::Request& request);

  GetModelInfo::Response model_info() const;

 private:
  PredictRollout::Response roll_out(const PredictRollout::Request& request);

  NodeParameters parameters_;
  Forecaster& forecaster_;
  LiveScene& live_scene_;
  const FrameTransformer& frames_;
  ros::ServiceServer predict_rollout_;
  ros::ServiceServer get_model_info_;
  ros::ServiceServer reset_;
};

}  // namespace rigidformer_ros
