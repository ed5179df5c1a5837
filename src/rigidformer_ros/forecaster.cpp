// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecaster.hpp"

#include <utility>
#include <vector>

#include "rigidformer_ros/length_scale.hpp"

namespace rigidformer_ros {

namespace {

std::vector<rigidformer::ObjectState> states(const ObservedScene& scene) {
  std::vector<rigidformer::ObjectState> objects;
  for (const ObservedObject& object : scene.objects) {
    objects.push_back(object.state);
  }
  return objects;
}

void skip_surplus(ObservedScene& scene, int max_objects) {
  while (max_objects > 0 && scene.objects.size() > static_cast<std::size_t>(max_objects)) {
    scene.skipped.push_back(
        {scene.objects.back().state.id, "the model takes at most " + std::to_string(max_objects) + " objects"});
    scene.objects.pop_back();
  }
}

}  // namespace

Forecaster::Forecaster(const NodeParameters& parameters, PredictorFactory make_predictor)
    : predict_(parameters.predict),
      num_steps_(parameters.predict.num_steps),
      service_(parameters.service),
      worker_(std::move(make_predictor)) {}

double Forecaster::length_scale(const ObservedScene& scene, const rigidformer::ModelInfo& info) const {
  return predict_.length_scale ? *predict_.length_scale : automatic_length_scale(states(scene), info);
}

std::optional<rigidformer::ModelInfo> Forecaster::model() const {
  return ready() ? std::make_optional(worker_.info()) : std::nullopt;
}

rigidformer::ModelInfo Forecaster::model_for(const ObservedScene& scene) const {
  const rigidformer::ModelInfo info = worker_.info();
  return to_real_scale(info, length_scale(scene, info));
}

RolloutSettings Forecaster::default_settings() const {
  RolloutSettings settings;
  settings.options.num_steps = num_steps_;
  settings.options.time_step_s = predict_.time_step;
  settings.options.gravity = predict_.gravity;
  settings.options.ground_height_m = predict_.ground_height;
  settings.settle = settle_criterion(service_);
  return settings;
}

SceneRollout Forecaster::roll_out(ObservedScene scene, RolloutSettings settings) {
  const rigidformer::ModelInfo info = worker_.info();
  settings.length_scale = length_scale(scene, info);
  skip_surplus(scene, info.max_objects);
  RolloutOutcome outcome = rigidformer_ros::roll_out(worker_, states(scene), settings);
  return {std::move(scene), std::move(outcome), to_real_scale(info, settings.length_scale), /*trusted_horizon_s=*/0.0};
}

}  // namespace rigidformer_ros
