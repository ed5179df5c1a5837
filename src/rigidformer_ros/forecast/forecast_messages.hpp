// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseArray.h>
#include <nav_msgs/Path.h>
#include <rigidformer_ros/SceneForecast.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <string>
#include <vector>

#include "rigidformer_ros/forecast/scene_forecaster.hpp"

namespace rigidformer_ros {

/// Which part of a rollout goes into a message.
struct ForecastSelection {
  std::vector<std::string> object_ids;  ///< Empty = all
  int record_every = 1;                 ///< Every n-th step, from the observation on
};

/// Name and first digits of the hash.
std::string model_label(const rigidformer::ModelInfo& model);

SceneForecast to_forecast(const SceneRollout& rollout, const ForecastSelection& selection,
                          const std::string& fixed_frame);

/// Every record_every-th value, the first one included.
std::vector<float> recorded_values(const std::vector<double>& values, int record_every);

/// How far the forecast of object `index` can be trusted: a constant of ObjectForecast. What is worst comes first.
std::uint8_t status_of(const SceneRollout& rollout, std::size_t index);

/// What the selected objects touch, with steps of the forecast, in the order of the first ones.
std::vector<ContactEvent> contact_events(const rigidformer::Forecast& forecast, const ForecastSelection& selection);

/// Points that to_points_cloud() would return.
std::uint64_t count_points(const ObservedScene& scene, const ForecastSelection& selection, int num_steps);

/// All selected objects' points at all selected times, `first_step` on: x y z label step t.
sensor_msgs::PointCloud2 to_points_cloud(const SceneRollout& rollout, const ForecastSelection& selection,
                                         const std::string& fixed_frame, int first_step = 0);

/// One object's points at step k of the rollout, stamped t0 + times[k].
sensor_msgs::PointCloud2 object_points_at(const SceneRollout& rollout, std::size_t object, std::size_t step,
                                          const std::string& fixed_frame);

/// One object's predicted poses, each stamped t0 + times[k].
nav_msgs::Path path_of(const SceneRollout& rollout, std::size_t object, const std::string& fixed_frame);

/// Poses of all objects at step k, in the order of the forecast, stamped t0 + times[k].
geometry_msgs::PoseArray poses_at(const SceneRollout& rollout, std::size_t step, const std::string& fixed_frame);

}  // namespace rigidformer_ros
