// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <rigidformer_ros/PredictRollouts.h>
#include <rigidformer_ros/PredictRolloutsAction.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>

#include <functional>

#include "rigidformer_ros/services/batch_answer.hpp"

namespace rigidformer_ros {

/// The service and the action predict_rollouts. The service always returns true; a failure is told in the answer. The
/// action has one goal at a time: a new one preempts the one before, which ends with what is done by then.
class BatchService {
 public:
  /// Called with every answer that has results.
  using Listener = std::function<void(const BatchRequest& request, const BatchResult& result)>;

  /// Handlers of the service run on the callback queue of `node`, the action has a thread of its own.
  BatchService(ros::NodeHandle& node, BatchAnswerer& answerer, Listener listener);
  ~BatchService();

 private:
  BatchResult answer(const BatchRequest& request, const BatchWatcher& watcher);
  void pursue(const PredictRolloutsGoalConstPtr& goal);

  BatchAnswerer& answerer_;
  Listener listener_;
  ros::ServiceServer service_;
  actionlib::SimpleActionServer<PredictRolloutsAction> action_;
};

}  // namespace rigidformer_ros
