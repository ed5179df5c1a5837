// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/outputs/forecast_loop.hpp"

#include <ros/console.h>

#include <algorithm>
#include <string>
#include <utility>

#include "rigidformer_ros/forecast/forecast_messages.hpp"
#include "rigidformer_ros/messages/conversions.hpp"

namespace rigidformer_ros {

namespace {

// With the nearest time step that the model takes: that may hang on the sizes in the scene, and the scene's velocities
// on the time step.
ObservedScene newest_scene(const LiveScene& live_scene, const SceneForecaster& forecaster, double wished_step_s) {
  ObservedScene scene = live_scene.snapshot(wished_step_s);
  const double time_step_s = forecaster.nearest_time_step(scene, wished_step_s);
  return time_step_s == wished_step_s ? scene : live_scene.snapshot(time_step_s);
}

const char* reason_of(rigidformer::SkipCause cause) {
  switch (cause) {
    case rigidformer::SkipCause::kUnusable:
      return kUnusableObject;
    case rigidformer::SkipCause::kSurplus:
      return "object beyond the model's limit";
    default:
      return "object not seen with the others";
  }
}

// Unusable ones among the first `num_known` were counted when their clouds came.
void count_skipped(const ObservedScene& scene, std::size_t num_known, RejectionLog& rejections) {
  for (std::size_t i = 0; i < scene.skipped.size(); ++i) {
    const rigidformer::SkippedObject& skipped = scene.skipped[i];
    if (i >= num_known || skipped.cause != rigidformer::SkipCause::kUnusable) {
      rejections.add(reason_of(skipped.cause), "'" + skipped.id + "': " + skipped.reason);
    }
  }
}

void note_incomplete(const SceneRollout& rollout, RejectionLog& rejections) {
  for (std::size_t i = 0; i < rollout.scene.objects.size(); ++i) {
    if (status_of(rollout, i) != ObjectForecast::INCOMPLETE) continue;
    rejections.note("object seen in part", "'" + rollout.scene.objects[i].state.id +
                                               "': forecast with status INCOMPLETE, its shape is a guess");
  }
}

}  // namespace

// A wall timer: it also runs while a simulated clock stands still.
ForecastLoop::ForecastLoop(ros::NodeHandle& node, const NodeParameters& parameters, const Context& context)
    : context_(context),
      tuned_(parameters),
      parameters_(parameters),
      publisher_(node, parameters),
      check_(parameters.diagnostics.check_window),
      timer_(node.createWallTimer(ros::WallDuration(1.0 / parameters.predict.rate),
                                  [this](const ros::WallTimerEvent&) { on_timer(); })) {}

// An exception that leaves a timer callback would end the node.
void ForecastLoop::on_timer() {
  try {
    take_over_tuning();
    context_.live_scene.watch_clock(ros::Time::now());
    if (context_.live_scene.epoch() != epoch_) {
      start_over();
    }
    check_forecasts();
    forecast_newest_scene();
  } catch (const std::exception& error) {
    context_.rejections.add(kFailedForecast, error.what());
  }
}

void ForecastLoop::take_over_tuning() {
  const double rate_before = parameters_.predict.rate;
  parameters_ = tuned_.get();
  publisher_.set_display(parameters_.display);
  if (parameters_.predict.rate != rate_before) {
    timer_.setPeriod(ros::WallDuration(1.0 / parameters_.predict.rate));
  }
}

// Everything was forgotten: so is what was derived from it.
void ForecastLoop::start_over() {
  epoch_ = context_.live_scene.epoch();
  check_.reset();
  context_.quality.set({});
  publisher_.clear();
  last_size_ = 0;
}

void ForecastLoop::check_forecasts() {
  if (check_.compare(context_.live_scene.records()) == 0) {
    return;
  }
  ForecastQuality quality;
  quality.errors = check_.errors();
  quality.trusted_horizon_s = trusted_horizon_s(quality.errors, parameters_.diagnostics.trusted_position_error,
                                                parameters_.diagnostics.trusted_rotation_error);
  publisher_.publish(quality, last_stamp_);
  context_.quality.set(std::move(quality));
}

void ForecastLoop::report_ready_once() {
  if (reported_ready_) {
    return;
  }
  reported_ready_ = true;
  const std::string device = context_.forecaster.model()->device;
  ROS_INFO_STREAM("Ready: the model is loaded and warmed up on " << device << ".");
  if (parameters_.model.device == "auto" && device == "cpu") {
    ROS_WARN("model/device is auto and no GPU is usable: predictions are made on the CPU.");
  }
}

void ForecastLoop::forecast_newest_scene() {
  if (!context_.forecaster.ready()) {
    return;
  }
  report_ready_once();
  ObservedScene scene = newest_scene(context_.live_scene, context_.forecaster, parameters_.predict.time_step);
  const std::size_t num_known = scene.skipped.size();
  scene = context_.forecaster.usable_part(std::move(scene));
  context_.input.scene_seen(scene.objects.size(), scene.skipped.size());
  if (!scene.clock_remark.empty()) {
    context_.rejections.note("clocks that differ", scene.clock_remark);
  }
  if (!is_new(scene)) {
    return;
  }
  count_skipped(scene, num_known, context_.rejections);
  if (!scene.objects.empty()) {
    forecast(std::move(scene));
  } else {
    publisher_.clear();
  }
}

// Whether it has not been dealt with yet; what an outdated one left behind is removed.
bool ForecastLoop::is_new(const ObservedScene& scene) {
  // What matters is whether clouds still come: a slow segmentation delivers them late, but steadily.
  if (!context_.live_scene.is_fed(to_stamp(ros::Time::now()), parameters_.history.object_timeout)) {
    publisher_.clear();
    last_size_ = 0;
    return false;
  }
  const bool is_same = scene.stamp == last_stamp_ && scene.objects.size() == last_size_;
  last_stamp_ = scene.stamp;
  last_size_ = scene.objects.size();
  return !is_same;
}

void ForecastLoop::forecast(ObservedScene scene) {
  const std::size_t num_skipped = scene.skipped.size();
  const ForecastTimer forecast_timer(context_.timing, parameters_.diagnostics.max_processing_time);
  RolloutSettings settings = context_.forecaster.default_settings();
  settings.options.time_step_s = scene.time_step_s;
  SceneRollout rollout = context_.forecaster.roll_out(std::move(scene), settings);
  context_.timing.add(Stage::kInference, rollout.outcome.forecast.compute_time_s);
  if (context_.live_scene.epoch() != epoch_) {
    return;  // forgotten while it was computed
  }
  count_skipped(rollout.scene, num_skipped, context_.rejections);
  note_incomplete(rollout, context_.rejections);
  rollout.trusted_horizon_s = context_.quality.get().trusted_horizon_s;
  publisher_.publish(rollout);
  context_.input.forecast_made();
  check_.expect(rollout);
}

}  // namespace rigidformer_ros
