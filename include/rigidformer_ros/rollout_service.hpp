// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/GetModelInfo.h>
#include <rigidformer_ros/PredictRollout.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <functional>
#include <mutex>

#include "rigidformer_ros/forecast_check.hpp"
#include "rigidformer_ros/forecaster.hpp"
#include "rigidformer_ros/frame_transformer.hpp"
#include "rigidformer_ros/live_scene.hpp"
#include "rigidformer_ros/parameters.hpp"
#include "rigidformer_ros/shared_answers.hpp"
#include "rigidformer_ros/shared_value.hpp"

namespace rigidformer_ros {

/// The services predict_rollout, get_model_info and reset. Handlers always return true, with failures in the answer.
/// Rollouts are made one after another, service/max_clients_queued may wait; the other services never wait for them.
/// Requests about the live scene that wait and are the same to the bit get one answer: it is made when the first of
/// them has its turn, so none gets one older than its question.
class RolloutService {
 public:
  /// Threads that the callback queue of `node` needs: one per rollout that is made or waits, one to turn others away.
  static std::uint32_t num_threads(const ServiceParameters& parameters) {
    return static_cast<std::uint32_t>(parameters.max_clients_queued) + 2;
  }

  /// Handlers run on the callback queue of `node`. All references must outlive the service.
  RolloutService(ros::NodeHandle& node, const NodeParameters& parameters, Forecaster& forecaster, LiveScene& live_scene,
                 const FrameTransformer& frames, const SharedValue<ForecastQuality>& quality);

  /// Answers one request; never throws. May be called from any thread.
  PredictRollout::Response answer(const PredictRollout::Request& request);

  GetModelInfo::Response model_info() const;

 private:
  PredictRollout::Response answer_together(const PredictRollout::Request& request, double start_s);
  PredictRollout::Response answer_in_turn(const PredictRollout::Request& request, double start_s,
                                          const std::function<void()>& when_it_begins);
  PredictRollout::Response roll_out(const PredictRollout::Request& request, double waited_s);

  NodeParameters parameters_;
  Forecaster& forecaster_;
  LiveScene& live_scene_;
  const FrameTransformer& frames_;
  const SharedValue<ForecastQuality>& quality_;
  std::atomic<int> num_clients_{0};  ///< Whose rollout is made or waits
  SharedAnswers<PredictRollout::Response> shared_answers_;
  std::timed_mutex turn_;
  ros::ServiceServer predict_rollout_;
  ros::ServiceServer get_model_info_;
  ros::ServiceServer reset_;
};

}  // namespace rigidformer_ros
