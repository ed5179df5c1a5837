// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/accuracy/tracking_accuracy.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/tracking/track_store.hpp"
#include "rigidformer_ros/simulated/camera/camera_scene.hpp"

namespace rigidformer_ros::camera {
namespace {

using rigidformer::AddResult;
using rigidformer::ObjectObservation;
using rigidformer::RigidTransform;
using rigidformer::Stamp;

const Stamp kStart = rigidformer::stamp_at(1000.0);
constexpr std::chrono::milliseconds kWait(10);
constexpr int kMostWaits = 30000;  // Five minutes to warm up
constexpr double kTargetPosition_m = 0.01;
constexpr double kTargetRotation_rad = 3.0 * M_PI / 180.0;

using ForecastKey = std::tuple<int, int, std::string>;  // Scene, frame, object

struct ForecastSample {
  std::vector<double> errors_m;  // Per horizon
  bool seen_well = false;
};

// One method's way through all scenes.
struct Run {
  MethodAccuracy accuracy;
  int num_within = 0;
  std::map<ForecastKey, ForecastSample> forecasts;
};

// Empty when no rotation of the shape can be seen.
std::optional<double> rotation_error(const std::string& shape, const RigidTransform& actual,
                                     const RigidTransform& truth) {
  if (rigidformer::symmetry_of(shape) == rigidformer::Symmetry::kAll) {
    return std::nullopt;
  }
  return rigidformer::visible_angle(shape, actual.rotation, truth.rotation);
}

// One scene for one method.
class ScenePlay {
 public:
  ScenePlay(const CameraScene& scene, int scene_number, const AccuracyOptions& options, NodeParameters parameters,
            Run& run)
      : scene_(scene),
        scene_number_(scene_number),
        options_(options),
        parameters_(with_method(std::move(parameters), run.accuracy.method)),
        tracks_(tracking_options(parameters_)),
        run_(run) {}

  void take_frame(int frame, const CameraView& view, const std::vector<double>& visible, SceneForecaster* forecaster) {
    for (int object = 0; object < scene_.num_objects(); ++object) {
      const AddResult result = tracks_.add(observe(frame, view, object));
      if (result == AddResult::kNewTrack || result == AddResult::kTimeRestarted) {
        T_reference_body_.erase(CameraScene::object_id(object));
        ++run_.accuracy.num_tracks;
      }
    }
    ObservedScene observed = tracks_.snapshot(parameters_.predict.time_step);
    compare_poses(observed, visible);
    if (forecaster != nullptr) {
      compare_forecast(frame, std::move(observed), visible, *forecaster);
    }
  }

 private:
  static NodeParameters with_method(NodeParameters parameters, const std::string& method) {
    const auto value = rigidformer::enum_value<rigidformer::Correspondence>(method);
    if (!value) {
      throw std::invalid_argument("correspondence method '" + method + "', must be ordered, registration or pose");
    }
    parameters.correspondence.method = *value;
    return parameters;
  }

  ObjectObservation observe(int frame, const CameraView& view, int object) const {
    const double time_s = scene_.time_s(frame);
    ObjectObservation observation;
    observation.id = CameraScene::object_id(object);
    observation.stamp = kStart + rigidformer::to_duration(time_s);
    if (run_.accuracy.method == "ordered") {
      observation.points_world = scene_.T_world_object(object, time_s).apply(scene_.surface_points(object));
    } else {
      observation.points_world = scene_.T_world_camera().apply(view.points_of(object));
    }
    if (run_.accuracy.method == "pose") {
      observation.T_world_object = scene_.T_world_object(object, time_s);
    }
    return observation;
  }

  int number_of(const std::string& id) const {
    int object = 0;
    while (CameraScene::object_id(object) != id) {
      ++object;
    }
    return object;
  }

  RigidTransform truth(int object, Stamp stamp, double ahead_s = 0.0) const {
    return scene_.T_world_object(object, rigidformer::seconds_between(kStart, stamp) + ahead_s);
  }

  // The frame of a track is where it began; the true pose at that moment says where the body frame is in it.
  void compare_poses(const ObservedScene& observed, const std::vector<double>& visible) {
    for (const ObservedObject& seen : observed.objects) {
      const int object = number_of(seen.state.id);
      const RigidTransform expected = truth(object, observed.stamp);
      const auto [entry, is_new] =
          T_reference_body_.try_emplace(seen.state.id, seen.state.T_world_current.inverse() * expected);
      if (is_new || visible[static_cast<std::size_t>(object)] < options_.min_visible) {
        continue;
      }
      const RigidTransform actual = seen.state.T_world_current * entry->second;
      const double position_m = (actual.translation - expected.translation).norm();
      const auto rotation_rad = rotation_error(scene_.shape_name(object), actual, expected);
      run_.accuracy.position_m.values.push_back(position_m);
      if (rotation_rad) {
        run_.accuracy.rotation_rad.values.push_back(*rotation_rad);
      }
      run_.num_within += position_m <= kTargetPosition_m && rotation_rad.value_or(0.0) <= kTargetRotation_rad;
    }
  }

  void compare_forecast(int frame, ObservedScene observed, const std::vector<double>& visible,
                        SceneForecaster& forecaster) {
    RolloutSettings settings = forecaster.default_settings();
    const double step_s = settings.options.time_step_s;
    settings.options.num_steps = static_cast<int>(std::lround(options_.horizons_s.back() / step_s));
    const SceneRollout rollout = forecaster.roll_out(std::move(observed), settings);
    for (std::size_t i = 0; i < rollout.scene.objects.size(); ++i) {
      const ObservedObject& seen = rollout.scene.objects[i];
      if (seen.assumed_static) {
        continue;
      }
      const int object = number_of(seen.state.id);
      ForecastSample sample;
      sample.seen_well = visible[static_cast<std::size_t>(object)] >= options_.min_visible;
      for (const double horizon_s : options_.horizons_s) {
        const auto step = static_cast<std::size_t>(std::lround(horizon_s / step_s));
        const RigidTransform predicted =
            rollout.outcome.forecast.objects[i].poses.at(step) * T_reference_body_.at(seen.state.id);
        const RigidTransform happened = truth(object, rollout.scene.stamp, static_cast<double>(step) * step_s);
        sample.errors_m.push_back((predicted.translation - happened.translation).norm());
      }
      run_.forecasts[{scene_number_, frame, seen.state.id}] = sample;
    }
  }

  const CameraScene& scene_;
  int scene_number_;
  const AccuracyOptions& options_;
  NodeParameters parameters_;
  rigidformer::TrackStore tracks_;
  Run& run_;
  std::map<std::string, RigidTransform> T_reference_body_;
};

// Forecasts start when there is a velocity and end early enough for the longest horizon.
bool is_forecast_frame(const CameraScene& scene, int frame, const AccuracyOptions& options) {
  const auto frames_between = static_cast<int>(std::lround(options.forecast_interval_s * options.camera.frame_rate));
  const double end_s = scene.time_s(scene.num_frames() - 1) - options.horizons_s.back();
  return frame > 0 && frame % frames_between == 0 && scene.time_s(frame) <= end_s + 1e-9;
}

void play_scene(int number, const AccuracyOptions& options, const NodeParameters& parameters,
                SceneForecaster& forecaster, std::vector<Run>& runs) {
  const CameraScene scene(options.camera, static_cast<std::uint64_t>(number));
  std::vector<ScenePlay> plays;
  for (Run& run : runs) {
    plays.emplace_back(scene, number, options, parameters, run);
  }
  for (int frame = 0; frame < scene.num_frames(); ++frame) {
    const CameraView view = scene.view(frame);
    std::vector<double> visible;
    for (int object = 0; object < scene.num_objects(); ++object) {
      visible.push_back(scene.visible_fraction(view, object));
    }
    SceneForecaster* const asked = is_forecast_frame(scene, frame, options) ? &forecaster : nullptr;
    for (ScenePlay& play : plays) {
      play.take_frame(frame, view, visible, asked);
    }
  }
}

bool is_in_all(const std::vector<Run>& runs, const ForecastKey& key) {
  return std::all_of(runs.begin(), runs.end(), [&](const Run& run) { return run.forecasts.count(key) == 1; });
}

void summarise(const std::vector<Run>& runs, std::size_t num_horizons, Run& run) {
  MethodAccuracy& accuracy = run.accuracy;
  const auto count = static_cast<double>(accuracy.position_m.values.size());
  accuracy.within_target = count > 0.0 ? run.num_within / count : 0.0;
  accuracy.forecast_m.resize(num_horizons);
  accuracy.forecast_seen_m.resize(num_horizons);
  for (const auto& [key, sample] : run.forecasts) {
    for (std::size_t h = 0; h < num_horizons && is_in_all(runs, key); ++h) {
      accuracy.forecast_m[h].values.push_back(sample.errors_m[h]);
      if (sample.seen_well) {
        accuracy.forecast_seen_m[h].values.push_back(sample.errors_m[h]);
      }
    }
  }
}

}  // namespace

std::vector<MethodAccuracy> measure_accuracy(const AccuracyOptions& options, const NodeParameters& parameters,
                                             SceneForecaster& forecaster) {
  std::vector<Run> runs(options.methods.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].accuracy.method = options.methods[i];
  }
  for (int number = 0; number < options.camera.num_scenes; ++number) {
    play_scene(number, options, parameters, forecaster, runs);
  }
  std::vector<MethodAccuracy> methods;
  for (Run& run : runs) {
    summarise(runs, options.horizons_s.size(), run);
    methods.push_back(run.accuracy);
  }
  return methods;
}

std::unique_ptr<SceneForecaster> make_ready_forecaster(const NodeParameters& parameters,
                                                       std::unique_ptr<rigidformer::Predictor> predictor) {
  const auto holder = std::make_shared<std::unique_ptr<rigidformer::Predictor>>(std::move(predictor));
  auto forecaster = std::make_unique<SceneForecaster>(parameters, [holder] { return std::move(*holder); });
  for (int waits = 0; !forecaster->ready(); ++waits) {
    if (waits == kMostWaits) {
      throw std::runtime_error(forecaster->message());
    }
    std::this_thread::sleep_for(kWait);
  }
  return forecaster;
}

}  // namespace rigidformer_ros::camera
