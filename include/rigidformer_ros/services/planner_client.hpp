// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <rigidformer_ros/PredictRollout.h>
#include <rigidformer_ros/PredictRolloutsAction.h>

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

/// What a planner needs to ask for rollouts, without a library to link: catkin's include folders and roscpp suffice.
namespace rigidformer_ros {

/// A request as a whole had no answer. `code` is one of PredictRollout, or kNoAnswer.
class PlannerError : public std::runtime_error {
 public:
  static constexpr std::int32_t kNoAnswer = 0;  ///< No node, or none that answered in time

  PlannerError(std::int32_t code, const std::string& message) : std::runtime_error(message), code_(code) {}
  std::int32_t code() const { return code_; }

 private:
  std::int32_t code_;
};

/// One object's outcomes in all candidates, row i = candidate i. Rows of candidates that failed are NaN.
struct OutcomeArrays {
  Eigen::Array<bool, Eigen::Dynamic, 1> ok;                   ///< [N] the candidate has no error and has the object
  Eigen::Matrix<double, Eigen::Dynamic, 3> end_positions;     ///< [N, 3] m, fixed frame
  Eigen::Matrix<double, Eigen::Dynamic, 4> end_orientations;  ///< [N, 4] x y z w
  Eigen::VectorXd max_tilt, path_length;                      ///< [N] rad, m
  Eigen::Matrix<int, Eigen::Dynamic, 1> first_contact_step, settled_step;  ///< [N] -1 = never
};

inline OutcomeArrays outcomes_of(const BatchResult& result, const std::string& object_id) {
  const auto count = static_cast<Eigen::Index>(result.results.size());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  OutcomeArrays arrays;
  arrays.ok.setConstant(count, false);
  arrays.end_positions.setConstant(count, 3, nan);
  arrays.end_orientations.setConstant(count, 4, nan);
  arrays.max_tilt.setConstant(count, nan);
  arrays.path_length.setConstant(count, nan);
  arrays.first_contact_step.setConstant(count, -1);
  arrays.settled_step.setConstant(count, -1);
  for (Eigen::Index i = 0; i < count; ++i) {
    const CandidateResult& candidate = result.results[static_cast<std::size_t>(i)];
    if (candidate.error_code != PredictRollout::Response::SUCCESS) continue;
    for (const ObjectOutcome& object : candidate.objects) {
      if (object.id != object_id) continue;
      const geometry_msgs::Pose& pose = object.end_pose;
      arrays.ok[i] = true;
      arrays.end_positions.row(i) << pose.position.x, pose.position.y, pose.position.z;
      arrays.end_orientations.row(i) << pose.orientation.x, pose.orientation.y, pose.orientation.z, pose.orientation.w;
      arrays.max_tilt[i] = object.max_tilt;
      arrays.path_length[i] = object.path_length;
      arrays.first_contact_step[i] = object.first_contact_step;
      arrays.settled_step[i] = object.settled_step;
    }
  }
  return arrays;
}

/// Asks a prediction node for rollouts of candidates through its action. It waits for the node, also for one that
/// restarts, and never longer than it is told. One thread uses it; it needs no spinner.
class PlannerClient {
 public:
  /// `action` is the name of the action, relative to the namespace of this process. Wall times in seconds: how long to
  /// wait for a node, and for an answer beyond the `max_wall_time` of the request.
  explicit PlannerClient(const std::string& action = "predict_rollouts", double connect_s = 10.0, double answer_s = 5.0)
      : client_(action, /*spin_thread=*/true), action_(action), connect_s_(connect_s), answer_s_(answer_s) {}

  /// Throws PlannerError when there is no node, no answer in time, or an error of the request as a whole. What is wrong
  /// with single candidates stands in their results.
  BatchResult predict(const BatchRequest& request) {
    if (!client_.waitForServer(ros::Duration(connect_s_))) {
      throw PlannerError(PlannerError::kNoAnswer, "no node offers the action " + action_);
    }
    PredictRolloutsGoal goal;
    goal.request = request;
    client_.sendGoal(goal);
    constexpr double kDefaultWallTime_s = 10.0;  // the node's service/max_wall_time unless it is set otherwise
    const double wall_time_s = request.max_wall_time.isZero() ? kDefaultWallTime_s : request.max_wall_time.toSec();
    if (!client_.waitForResult(ros::Duration(wall_time_s + answer_s_))) {
      client_.cancelGoal();
      throw PlannerError(PlannerError::kNoAnswer, action_ + ": no answer in time");
    }
    const auto answer = client_.getResult();
    if (!answer) throw PlannerError(PlannerError::kNoAnswer, action_ + ": the goal was lost");
    if (answer->result.results.empty()) throw PlannerError(answer->result.error_code, answer->result.message);
    return answer->result;
  }

 private:
  actionlib::SimpleActionClient<PredictRolloutsAction> client_;
  std::string action_;
  double connect_s_, answer_s_;
};

}  // namespace rigidformer_ros
