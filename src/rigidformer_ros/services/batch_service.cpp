// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/batch_service.hpp"

#include <rigidformer_ros/PredictRollout.h>
#include <ros/init.h>

#include <boost/function.hpp>
#include <utility>

#include "rigidformer_ros/messages/names.hpp"

namespace rigidformer_ros {

BatchService::BatchService(ros::NodeHandle& node, BatchAnswerer& answerer, Listener listener)
    : answerer_(answerer),
      listener_(std::move(listener)),
      action_(
          node, names::kPredictRollouts, [this](const PredictRolloutsGoalConstPtr& goal) { pursue(goal); },
          /*auto_start=*/false) {
  using Request = PredictRollouts::Request;
  using Response = PredictRollouts::Response;
  service_ = node.advertiseService<Request, Response>(
      names::kPredictRollouts, boost::function<bool(Request&, Response&)>([this](Request& request, Response& response) {
        response.result = answer(request.request, {});
        return true;
      }));
  action_.start();
}

BatchService::~BatchService() { action_.shutdown(); }

BatchResult BatchService::answer(const BatchRequest& request, const BatchWatcher& watcher) {
  BatchResult result = answerer_.answer(request, watcher);
  if (!result.results.empty()) {
    listener_(request, result);
  }
  return result;
}

void BatchService::pursue(const PredictRolloutsGoalConstPtr& goal) {
  BatchWatcher watcher;
  watcher.is_cancelled = [this] { return action_.isPreemptRequested() || !ros::ok(); };
  watcher.tell = [this](const BatchProgress& progress) {
    PredictRolloutsFeedback feedback;
    feedback.steps_done = static_cast<std::uint32_t>(progress.steps_done);
    feedback.num_steps = static_cast<std::uint32_t>(progress.num_steps);
    feedback.num_done = static_cast<std::uint32_t>(progress.num_done);
    feedback.indices = progress.indices;
    feedback.results = progress.results;
    action_.publishFeedback(feedback);
  };
  PredictRolloutsResult result;
  result.result = answer(goal->request, watcher);
  if (result.result.error_code == PredictRollout::Response::PREEMPTED) {
    action_.setPreempted(result, result.result.message);
  } else if (result.result.success) {
    action_.setSucceeded(result);
  } else {
    action_.setAborted(result, result.result.message);
  }
}

}  // namespace rigidformer_ros
