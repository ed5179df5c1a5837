// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/scene_forecaster.hpp"

#include <utility>
#include <vector>

#include "rigidformer_ros/forecast/length_scale.hpp"

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

SceneForecaster::SceneForecaster(const NodeParameters& parameters, PredictorFactory make_predictor)
    : predict_(parameters.predict),
      num_steps_(parameters.predict.num_steps),
      service_(parameters.service),
      worker_(std::move(make_predictor)) {}

double SceneForecaster::length_scale(const ObservedScene& scene, const rigidformer::ModelInfo& info) const {
  return predict_.length_scale ? *predict_.length_scale : automatic_length_scale(states(scene), info);
}

std::optional<rigidformer::ModelInfo> SceneForecaster::model() const {
  return ready() ? std::make_optional(worker_.info()) : std::nullopt;
}

rigidformer::ModelInfo SceneForecaster::model_for(const ObservedScene& scene) const {
  const rigidformer::ModelInfo info = worker_.info();
  return to_real_scale(info, length_scale(scene, info));
}

RolloutSettings SceneForecaster::default_settings() const {
  RolloutSettings settings;
  settings.options.num_steps = num_steps_;
  settings.options.time_step_s = predict_.time_step;
  settings.options.gravity = predict_.gravity;
  settings.options.ground_height_m = predict_.ground_height;
  settings.settle = settle_criterion(service_);
  return settings;
}

std::shared_ptr<BegunRollout> SceneForecaster::begin(ObservedScene scene, const rigidformer::RolloutOptions& options,
                                                     std::set<int> ends, JobLane lane) {
  const rigidformer::ModelInfo info = worker_.info();
  const double scale = length_scale(scene, info);
  skip_surplus(scene, info.max_objects);
  std::vector<rigidformer::ObjectState> objects = states(scene);
  return std::shared_ptr<BegunRollout>(
      new BegunRollout{std::move(scene), to_real_scale(info, scale),
                       SharedRollout(worker_, objects, options, scale, std::move(ends), lane)});
}

SceneRollout SceneForecaster::roll_out(ObservedScene scene, const RolloutSettings& settings) {
  const auto begun = begin(std::move(scene), settings.options, {settings.options.num_steps}, JobLane::kForecast);
  RolloutOutcome outcome = rigidformer_ros::roll_out(begun->steps, settings);
  return {std::move(begun->scene), std::move(outcome), begun->model, /*trusted_horizon_s=*/0.0};
}

}  // namespace rigidformer_ros
