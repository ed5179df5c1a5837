// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// Topic and service names, relative to the node's namespace.
namespace rigidformer_ros::names {

// The topics that the node publishes.
inline constexpr char kForecast[] = "forecast";
inline constexpr char kForecastCloud[] = "forecast_cloud";
inline constexpr char kPredictedPoses[] = "predicted_poses";
inline constexpr char kMarkers[] = "markers";
inline constexpr char kForecastError[] = "forecast_error";
inline constexpr char kCandidateMarkers[] = "candidate_markers";

// The services that the node offers.
inline constexpr char kPredictRollout[] = "predict_rollout";
inline constexpr char kPredictRollouts[] = "predict_rollouts";
inline constexpr char kGetModelInfo[] = "get_model_info";
inline constexpr char kReset[] = "reset";

/// Topic of one object's points at the first predicted step. Characters of the id that a ROS name cannot hold become
/// '_'; two objects whose ids then are equal share the topic.
std::string predicted_points(const std::string& object_id);

/// Topic of one object's predicted path. The id is changed in the same way as in predicted_points().
std::string path(const std::string& object_id);

}  // namespace rigidformer_ros::names
