// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/GetModelInfo.h>
#include <rigidformer_ros/PredictRollout.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <optional>
#include <set>

#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/health/forecast_check.hpp"
#include "rigidformer_ros/health/shared_value.hpp"
#include "rigidformer_ros/inputs/frame_transformer.hpp"
#include "rigidformer_ros/inputs/live_scene.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"
#include "rigidformer_ros/services/client_count.hpp"
#include "rigidformer_ros/services/rollout_groups.hpp"
#include "rigidformer_ros/services/rollout_request.hpp"

namespace rigidformer_ros {

/// The services predict_rollout, get_model_info and reset. Handlers always return true; a failure is told in the
/// answer. Rollouts take turns of a few steps with each other, and every other turn is the forecast's. Requests that
/// wait for the same scene and time step share one rollout, each with its own number of steps, objects and time limit.
/// A request with a filled candidate has a rollout of its own. At most service/max_clients_queued requests beside one
/// may be under way or wait; further ones are refused. The other services never wait for rollouts.
class RolloutService {
 public:
  /// The number of threads that the callback queue of `node` needs: one per request that is answered or waits, one to
  /// refuse further requests, and one for the goals of the action predict_rollouts.
  static std::uint32_t num_threads(const ServiceParameters& parameters) {
    return static_cast<std::uint32_t>(parameters.max_clients_queued) + 3;
  }

  /// Handlers run on the callback queue of `node`. All references must outlive the service.
  RolloutService(ros::NodeHandle& node, const NodeParameters& parameters, SceneForecaster& forecaster,
                 LiveScene& live_scene, const FrameTransformer& frames, const SharedValue<ForecastQuality>& quality,
                 ClientCount& clients);

  /// Answers one request and never throws. This may be called from any thread.
  PredictRollout::Response answer(const PredictRollout::Request& request);

  /// Describes the model, with its ranges at the length scale of the live scene.
  GetModelInfo::Response model_info() const;

 private:
  PredictRollout::Response answer_ready(const PredictRollout::Request& request, SharedRollout::Clock::time_point asked);
  /// The steps of a scene as it is, shared with whoever waits for the same; empty if max_wall_time passed.
  std::optional<SceneRollout> roll_out(const PredictRollout::Request& request, RolloutTask& task,
                                       SharedRollout::Clock::time_point asked);
  /// The steps of a scene with changes.
  SceneRollout roll_out_candidate(const PredictRollout::Request& request, RolloutTask& task,
                                  SharedRollout::Clock::time_point asked);
  ObservedScene read(const PredictRollout::Request& request, const RolloutTask& task) const;
  std::shared_ptr<BegunRollout> begin(const PredictRollout::Request& request, const RolloutTask& task,
                                      const std::set<int>& ends);

  NodeParameters parameters_;
  SceneForecaster& forecaster_;
  LiveScene& live_scene_;
  const FrameTransformer& frames_;
  const SharedValue<ForecastQuality>& quality_;
  ClientCount& clients_;
  RolloutGroups<BegunRollout> groups_;
  ros::ServiceServer predict_rollout_;
  ros::ServiceServer get_model_info_;
  ros::ServiceServer reset_;
};

}  // namespace rigidformer_ros
