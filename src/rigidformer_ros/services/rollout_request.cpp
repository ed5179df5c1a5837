// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/services/rollout_request.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <utility>

#include "rigidformer/scene/objection.hpp"
#include "rigidformer_ros/messages/conversions.hpp"
#include "rigidformer_ros/messages/object_clouds.hpp"
#include "rigidformer_ros/services/request_error.hpp"

namespace rigidformer_ros {

namespace {

using Request = PredictRollout::Request;
using Response = PredictRollout::Response;

[[noreturn]] void reject(std::int32_t code, const std::string& message) { throw RequestError(code, message); }

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", value);
  return text;
}

int read_num_steps(const Request& request, const NodeParameters& parameters, int default_steps) {
  if (request.num_steps > static_cast<std::uint32_t>(parameters.service.max_steps)) {
    reject(Response::LIMIT_EXCEEDED, "num_steps: is " + std::to_string(request.num_steps) + ", at most " +
                                         std::to_string(parameters.service.max_steps) +
                                         " are allowed (service/max_steps)");
  }
  return request.num_steps == 0 ? std::min(default_steps, parameters.service.max_steps)
                                : static_cast<int>(request.num_steps);
}

double read_duration(const ros::Duration& given, const char* field, double default_s) {
  if (given < ros::Duration(0.0)) {
    reject(Response::INVALID_REQUEST,
           std::string(field) + ": is " + number(given.toSec()) + " s, must not be negative");
  }
  return given.isZero() ? default_s : given.toSec();
}

int read_record_every(const Request& request, int num_steps) {
  if (request.record_every > static_cast<std::uint32_t>(num_steps)) {
    reject(Response::INVALID_REQUEST, "record_every: is " + std::to_string(request.record_every) +
                                          ", must be at most the number of steps " + std::to_string(num_steps));
  }
  return std::max<int>(1, static_cast<int>(request.record_every));
}

double read_time_step(double requested, double default_s, const rigidformer::ModelInfo& model) {
  constexpr double kRounding = 1e-6;  // a range end written with few digits is still inside
  const double dt = requested == 0.0 ? std::clamp(default_s, model.min_time_step_s, model.max_time_step_s) : requested;
  const bool inside =
      dt >= model.min_time_step_s * (1.0 - kRounding) && dt <= model.max_time_step_s * (1.0 + kRounding);
  if (!std::isfinite(dt) || !inside) {
    reject(Response::INVALID_REQUEST, "time_step: is " + number(dt) + " s, the model is trained for [" +
                                          number(model.min_time_step_s) + ", " + number(model.max_time_step_s) + "] s");
  }
  return std::clamp(dt, model.min_time_step_s, model.max_time_step_s);
}

std::string known_ids(const ObservedScene& scene) {
  std::string text;
  for (const ObservedObject& object : scene.objects) {
    text += (text.empty() ? "" : ", ") + object.state.id;
  }
  return text;
}

// Whoever asks for an object that cannot be predicted has to change the request, whoever asks for one that is not seen
// may ask again.
std::int32_t code_of(rigidformer::SkipCause cause) {
  return cause == rigidformer::SkipCause::kUnusable ? Response::INVALID_REQUEST : Response::STALE_STATE;
}

std::string reasons(const std::vector<rigidformer::SkippedObject>& skipped) {
  constexpr std::size_t kMostTold = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(skipped.size(), kMostTold); ++i) {
    text += (i == 0 ? "'" : "; '") + skipped[i].id + "': " + skipped[i].reason;
  }
  return skipped.size() > kMostTold ? text + "; and " + std::to_string(skipped.size() - kMostTold) + " more" : text;
}

}  // namespace

void check_object_ids(const std::vector<std::string>& ids, const ObservedScene& scene) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::string name = "object_ids[" + std::to_string(i) + "]: '" + ids[i] + "'";
    if (!seen.insert(ids[i]).second) {
      reject(Response::INVALID_REQUEST, name + " occurs twice");
    }
    const auto has_id = [&](const ObservedObject& object) { return object.state.id == ids[i]; };
    if (std::any_of(scene.objects.begin(), scene.objects.end(), has_id)) {
      continue;
    }
    for (const rigidformer::SkippedObject& skipped : scene.skipped) {
      if (skipped.id == ids[i]) {
        reject(code_of(skipped.cause), name + " is left out: " + skipped.reason);
      }
    }
    reject(Response::UNKNOWN_OBJECT, name + " is not known; known: " + known_ids(scene));
  }
}

namespace {

void check_age(const ObservedScene& scene, const ros::Time& now, double max_age_s) {
  const double age = rigidformer::seconds_between(scene.stamp, to_stamp(now));
  if (age > max_age_s) {
    reject(Response::STALE_STATE,
           "max_state_age: the newest state is " + number(age) + " s old, accepted are " + number(max_age_s) + " s");
  }
}

// A forecast of objects of which no velocity is known would only say that they fall from rest.
void check_history(const ObservedScene& scene, const std::vector<std::string>& ids) {
  std::string waiting;
  for (const ObservedObject& object : scene.objects) {
    const bool reported = ids.empty() || std::count(ids.begin(), ids.end(), object.state.id) > 0;
    if (!reported) {
      continue;
    }
    if (!object.assumed_static) {
      return;
    }
    waiting = object.state.id;
  }
  if (!waiting.empty()) {
    reject(Response::INSUFFICIENT_HISTORY,
           "object '" + waiting + "': its observations do not reach one time_step back yet, no velocity is known");
  }
}

SceneSource read_source(const Request& request) {
  const bool has_previous = !is_empty(request.previous_scene);
  if (!is_empty(request.scene)) {
    return has_previous ? SceneSource::kGivenAndBefore : SceneSource::kGiven;
  }
  if (has_previous) {
    reject(Response::INVALID_REQUEST, "previous_scene: is filled although scene is empty");
  }
  return SceneSource::kLive;
}

ObservedScene take_given_scene(const TrackStore& tracks, bool has_previous, const rigidformer::ModelInfo& model,
                               double time_step_s) {
  ObservedScene scene = tracks.snapshot(time_step_s);
  if (model.max_objects > 0 && scene.objects.size() > static_cast<std::size_t>(model.max_objects)) {
    reject(Response::LIMIT_EXCEEDED, "scene.ids: has " + std::to_string(scene.objects.size()) +
                                         " objects, the model takes at most " + std::to_string(model.max_objects));
  }
  for (const ObservedObject& object : scene.objects) {
    if (has_previous && object.assumed_static) {
      reject(Response::INSUFFICIENT_HISTORY,
             "previous_scene.header.stamp: lies too close to scene.header.stamp to tell the state one time_step of " +
                 number(time_step_s) + " s earlier (at most one frame is extrapolated)");
    }
  }
  return scene;
}

std::string field_of(const Request& request, const std::string& id) {
  const auto found = std::find(request.scene.ids.begin(), request.scene.ids.end(), id);
  return "scene.clouds[" + std::to_string(found - request.scene.ids.begin()) + "]: object '" + id + "' ";
}

// A request that gives an object asks for its forecast, so that one which cannot be predicted is an error here.
void check_usable(const Request& request, const ObservedScene& scene, const PredictParameters& predict) {
  for (const ObservedObject& object : scene.objects) {
    if (const auto objection = rigidformer::objection(object.state, predict.length_scale)) {
      reject(Response::INVALID_REQUEST, field_of(request, object.state.id) + *objection);
    }
  }
  for (const rigidformer::SkippedObject& skipped : scene.skipped) {
    if (skipped.cause == rigidformer::SkipCause::kUnusable) {
      reject(Response::INVALID_REQUEST, field_of(request, skipped.id) + skipped.reason);
    }
  }
}

ObservedScene read_given_scene(const Request& request, bool has_previous, const NodeParameters& parameters,
                               double default_time_step_s, const RequestSources& sources) {
  const TrackStore tracks =
      track_scenes(request.scene, has_previous ? &request.previous_scene : nullptr, parameters, sources.T_fixed_from);
  const ObservedScene given = tracks.snapshot(default_time_step_s);
  check_usable(request, given, parameters.predict);
  const rigidformer::ModelInfo model = sources.model_for(given);
  return take_given_scene(tracks, has_previous, model, read_time_step(request.time_step, default_time_step_s, model));
}

ObservedScene read_live_scene(const Request& request, double default_time_step_s, const RequestSources& sources) {
  const rigidformer::ModelInfo model = sources.model_for(sources.live_scene(default_time_step_s));
  ObservedScene scene = sources.live_scene(read_time_step(request.time_step, default_time_step_s, model));
  if (scene.objects.empty() && scene.skipped.empty()) {
    reject(Response::NO_OBJECTS, "no object has been observed yet");
  }
  return scene;
}

void check_returned_points(const Request& request, const RolloutTask& task, const ObservedScene& scene,
                           const NodeParameters& parameters) {
  const std::uint64_t points = count_points(scene, task.selection, task.settings.options.num_steps);
  if (request.return_points && points > static_cast<std::uint64_t>(parameters.service.max_returned_points)) {
    reject(Response::LIMIT_EXCEEDED, "return_points: " + std::to_string(points) + " points, at most " +
                                         std::to_string(parameters.service.max_returned_points) +
                                         " are returned (service/max_returned_points); raise record_every");
  }
}

}  // namespace

RolloutTask read_task(const Request& request, const NodeParameters& parameters, const RolloutSettings& defaults) {
  RolloutTask task;
  task.settings = defaults;
  task.settings.options.num_steps = read_num_steps(request, parameters, defaults.options.num_steps);
  task.settings.max_wall_time_s =
      read_duration(request.max_wall_time, "max_wall_time", parameters.service.max_wall_time);
  task.settings.stop_when_settled = request.stop_when_settled;
  task.selection.object_ids = request.object_ids;
  task.selection.record_every = read_record_every(request, task.settings.options.num_steps);
  task.source = read_source(request);
  return task;
}

std::string rollout_key(const Request& request) {
  namespace serialization = ros::serialization;
  const std::uint32_t size =
      serialization::serializationLength(request.time_step) + serialization::serializationLength(request.scene) +
      serialization::serializationLength(request.previous_scene) + serialization::serializationLength(request.control);
  std::string bytes(size, '\0');
  serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()), size);
  serialization::serialize(stream, request.time_step);
  serialization::serialize(stream, request.scene);
  serialization::serialize(stream, request.previous_scene);
  serialization::serialize(stream, request.control);
  return bytes;
}

// The range of the time step may hang on the sizes in the scene, and the scene's velocities on the time step.
ObservedScene read_scene(const Request& request, SceneSource source, const NodeParameters& parameters,
                         double default_time_step_s, const RequestSources& sources) {
  if (source == SceneSource::kLive) {
    return read_live_scene(request, default_time_step_s, sources);
  }
  return read_given_scene(request, source == SceneSource::kGivenAndBefore, parameters, default_time_step_s, sources);
}

void check_scene(const Request& request, const RolloutTask& task, const ObservedScene& scene,
                 const NodeParameters& parameters, const ros::Time& now) {
  const bool is_live = task.source == SceneSource::kLive;
  if (is_live) {
    check_age(scene, now, read_duration(request.max_state_age, "max_state_age", parameters.service.max_state_age));
  }
  check_object_ids(request.object_ids, scene);
  if (scene.objects.empty()) {
    reject(is_live ? Response::NO_OBJECTS : Response::INVALID_REQUEST,
           (is_live ? "no object can be forecast: " : "scene: no object can be forecast: ") + reasons(scene.skipped));
  }
  if (is_live) {
    check_history(scene, request.object_ids);
  }
  check_returned_points(request, task, scene, parameters);
}

}  // namespace rigidformer_ros
