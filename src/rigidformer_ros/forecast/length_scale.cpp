// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/length_scale.hpp"

#include <algorithm>
#include <cmath>

namespace rigidformer_ros {

using rigidformer::Forecast;
using rigidformer::ModelInfo;
using rigidformer::ObjectState;
using rigidformer::RolloutOptions;

std::vector<ObjectState> to_model_scale(std::vector<ObjectState> objects, double scale) {
  if (scale == 1.0) {
    return objects;
  }
  for (ObjectState& object : objects) {
    object.points_reference /= static_cast<float>(scale);
    object.T_world_previous.translation /= scale;
    object.T_world_current.translation /= scale;
  }
  return objects;
}

RolloutOptions to_model_scale(RolloutOptions options, double scale) {
  options.time_step_s /= std::sqrt(scale);
  if (options.ground_height_m) {
    *options.ground_height_m /= scale;
  }
  return options;
}

Forecast to_real_scale(Forecast forecast, double scale) {
  for (double& time : forecast.times_s) {
    time *= std::sqrt(scale);
  }
  for (auto& object : forecast.objects) {
    for (auto& pose : object.poses) {
      pose.translation *= scale;
    }
  }
  return forecast;
}

ModelInfo to_real_scale(ModelInfo info, double scale) {
  info.min_time_step_s *= std::sqrt(scale);
  info.max_time_step_s *= std::sqrt(scale);
  info.min_size_m *= scale;
  info.max_size_m *= scale;
  info.max_speed_mps *= std::sqrt(scale);
  return info;
}

double object_diameter(const rigidformer::Points& points) {
  if (points.rows() == 0) {
    return 0.0;
  }
  const Eigen::RowVector3f centroid = points.colwise().mean();
  return 2.0 * (points.rowwise() - centroid).rowwise().norm().maxCoeff();
}

double automatic_length_scale(const std::vector<ObjectState>& objects, const ModelInfo& info) {
  const double trained = std::sqrt(info.min_size_m * info.max_size_m);
  if (objects.empty() || !(trained > 0.0)) {
    return 1.0;
  }
  std::vector<double> diameters;
  for (const ObjectState& object : objects) {
    diameters.push_back(object_diameter(object.points_reference));
  }
  const auto middle = diameters.begin() + static_cast<std::ptrdiff_t>(diameters.size() / 2);
  std::nth_element(diameters.begin(), middle, diameters.end());
  return *middle > 0.0 ? *middle / trained : 1.0;
}

}  // namespace rigidformer_ros
