// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/GetModelInfo.h>
#include <rigidformer_ros/PredictRollout.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <memory>
#include <set>

#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/health/forecast_check.hpp"
#include "rigidformer_ros/health/shared_value.hpp"
#include "rigidformer_ros/inputs/frame_transformer.hpp"
#include "rigidformer_ros/inputs/live_scene.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"
#include "rigidformer_ros/services/rollout_groups.hpp"
#include "rigidformer_ros/services/rollout_request.hpp"

namespace rigidformer_ros {

/// The services predict_rollout, get_model_info and reset. Handlers always return true; a failure is told in the
/// answer. Rollouts take turns of a few steps with each other, and every other turn is the forecast's. Requests that
/// wait for the same scene and time step share one rollout, each with its own number of steps, objects and time limit.
/// At most service/max_clients_queued requests beside one may be under way or wait; further ones are refused. The other
/// services never wait for rollouts.
class RolloutService {
 public:
  /// The number of threads that the callback queue of `node` needs: one per request that is answered or waits, and one
  /// to refuse further requests.
  static std::uint32_t num_threads(const ServiceParameters& parameters) {
    return static_cast<std::uint32_t>(parameters.max_clients_queued) + 2;
  }

  /// Handlers run on the callback queue of `node`. All references must outlive the service.
  RolloutService(ros::NodeHandle& node, const NodeParameters& parameters, SceneForecaster& forecaster,
                 LiveScene& live_scene, const FrameTransformer& frames, const SharedValue<ForecastQuality>& quality);

  /// Answers one request and never throws. This may be called from any thread.
  PredictRollout::Response answer(const PredictRollout::Request& request);

  /// Describes the model, with its ranges at the length scale of the live scene.
  GetModelInfo::Response model_info() const;

 private:
  PredictRollout::Response answer_ready(const PredictRollout::Request& request, SharedRollout::Clock::time_point asked);
  std::shared_ptr<BegunRollout> begin(const PredictRollout::Request& request, const RolloutTask& task,
                                      const std::set<int>& ends);

  NodeParameters parameters_;
  SceneForecaster& forecaster_;
  LiveScene& live_scene_;
  const FrameTransformer& frames_;
  const SharedValue<ForecastQuality>& quality_;
  std::atomic<int> num_clients_{0};  ///< Clients whose request is being answered or waits
  RolloutGroups<BegunRollout> groups_;
  ros::ServiceServer predict_rollout_;
  ros::ServiceServer get_model_info_;
  ros::ServiceServer reset_;
};

}  // namespace rigidformer_ros
