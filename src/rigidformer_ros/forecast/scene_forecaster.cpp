// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/forecast/scene_forecaster.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "rigidformer/length_scale.hpp"
#include "rigidformer/scene/objection.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::SkipCause;

std::vector<rigidformer::ObjectState> states(const ObservedScene& scene) {
  std::vector<rigidformer::ObjectState> objects;
  for (const ObservedObject& object : scene.objects) {
    objects.push_back(object.state);
  }
  return objects;
}

void skip_surplus(ObservedScene& scene, int max_objects) {
  while (max_objects > 0 && scene.objects.size() > static_cast<std::size_t>(max_objects)) {
    scene.skipped.push_back({scene.objects.back().state.id,
                             "the model takes at most " + std::to_string(max_objects) + " objects",
                             SkipCause::kSurplus});
    scene.objects.pop_back();
  }
}

// Whether there were any.
bool skip_unusable(ObservedScene& scene, std::optional<double> length_scale) {
  const std::size_t num_skipped = scene.skipped.size();
  std::vector<ObservedObject> usable;
  for (ObservedObject& object : scene.objects) {
    if (const auto objection = rigidformer::objection(object.state, length_scale)) {
      scene.skipped.push_back({object.state.id, *objection, SkipCause::kUnusable});
    } else {
      usable.push_back(std::move(object));
    }
  }
  scene.objects = std::move(usable);
  return scene.skipped.size() > num_skipped;
}

}  // namespace

SceneForecaster::SceneForecaster(const NodeParameters& parameters, PredictorFactory make_predictor)
    : predict_(parameters.predict),
      num_steps_(parameters.predict.num_steps),
      service_(parameters.service),
      worker_(std::move(make_predictor)) {}

// What is of no use must not decide at which scale the others are predicted, and what is too small at that scale is of
// no use.
double SceneForecaster::take_usable(ObservedScene& scene, const rigidformer::ModelInfo& info) const {
  skip_unusable(scene, predict_.length_scale);
  if (predict_.length_scale) {
    return *predict_.length_scale;
  }
  while (true) {
    const double length_scale = rigidformer::automatic_length_scale(states(scene), info);
    if (!skip_unusable(scene, length_scale)) {
      return length_scale;
    }
  }
}

ObservedScene SceneForecaster::usable_part(ObservedScene scene) const {
  const rigidformer::ModelInfo info = worker_.info();
  take_usable(scene, info);
  skip_surplus(scene, info.max_objects);
  return scene;
}

std::optional<rigidformer::ModelInfo> SceneForecaster::model() const {
  return ready() ? std::make_optional(worker_.info()) : std::nullopt;
}

rigidformer::ModelInfo SceneForecaster::model_for(const ObservedScene& scene) const {
  const rigidformer::ModelInfo info = worker_.info();
  if (predict_.length_scale) {
    return to_real_scale(info, *predict_.length_scale);
  }
  ObservedScene usable = scene;
  return to_real_scale(info, take_usable(usable, info));
}

double SceneForecaster::nearest_time_step(const ObservedScene& scene, double wished_s) const {
  const rigidformer::ModelInfo model = model_for(scene);
  return std::clamp(wished_s, model.min_time_step_s, model.max_time_step_s);
}

RolloutSettings SceneForecaster::default_settings() const {
  RolloutSettings settings;
  settings.options.num_steps = num_steps_;
  settings.options.time_step_s = predict_.time_step;
  settings.options.gravity = predict_.gravity;
  settings.options.ground_height_m = predict_.ground_height;
  settings.options.ground = {predict_.ground_friction, predict_.ground_restitution};
  settings.options.num_particles = predict_.num_particles;
  settings.settle = settle_criterion(service_);
  return settings;
}

std::shared_ptr<BegunRollout> SceneForecaster::begin(ObservedScene scene, const rigidformer::RolloutOptions& options,
                                                     std::set<int> ends, JobLane lane) {
  const rigidformer::ModelInfo info = worker_.info();
  const double scale = take_usable(scene, info);
  skip_surplus(scene, info.max_objects);
  std::vector<rigidformer::ObjectState> objects = states(scene);
  return std::shared_ptr<BegunRollout>(
      new BegunRollout{std::move(scene), to_real_scale(info, scale),
                       SharedRollout(worker_, objects, options, scale, std::move(ends), lane)});
}

std::unique_ptr<BegunBatch> SceneForecaster::begin_batch(ObservedScene scene,
                                                         const std::vector<rigidformer::Candidate>& candidates,
                                                         const rigidformer::BatchOptions& options) {
  const rigidformer::ModelInfo info = worker_.info();
  const double scale = take_usable(scene, info);
  skip_surplus(scene, info.max_objects);
  const std::vector<rigidformer::ObjectState> objects = states(scene);
  return std::unique_ptr<BegunBatch>(new BegunBatch{std::move(scene), to_real_scale(info, scale),
                                                    BatchRun(worker_, objects, candidates, options, scale)});
}

SceneRollout SceneForecaster::roll_out(ObservedScene scene, const RolloutSettings& settings) {
  const auto begun = begin(std::move(scene), settings.options, {settings.options.num_steps}, JobLane::kForecast);
  RolloutOutcome outcome = rigidformer_ros::roll_out(begun->steps, settings);
  SceneRollout rollout{std::move(begun->scene), std::move(outcome), begun->model, /*trusted_horizon_s=*/0.0};
  skip_unusable(rollout);
  return rollout;
}

void skip_unusable(SceneRollout& rollout) {
  std::vector<rigidformer::ObjectTrajectory>& forecasts = rollout.outcome.forecast.objects;
  for (std::size_t i = forecasts.size(); i-- > 0;) {
    if (forecasts[i].status != rigidformer::ObjectTrajectory::Status::kUnusable) {
      continue;
    }
    const auto index = static_cast<std::ptrdiff_t>(i);
    rollout.scene.skipped.push_back({forecasts[i].id, forecasts[i].reason, SkipCause::kUnusable});
    rollout.scene.objects.erase(rollout.scene.objects.begin() + index);
    rollout.outcome.settled_steps.erase(rollout.outcome.settled_steps.begin() + index);
    forecasts.erase(forecasts.begin() + index);
    for (rigidformer::StepContact& contact : rollout.outcome.forecast.contacts) {  // it has none itself
      contact.object_a -= contact.object_a > static_cast<int>(i) ? 1 : 0;
      contact.object_b -= contact.object_b > static_cast<int>(i) ? 1 : 0;
    }
  }
}

}  // namespace rigidformer_ros
