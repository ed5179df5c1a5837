// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/parameters.hpp"

#include <set>
#include <stdexcept>

#include "rigidformer_ros/parameters/parameter_reader.hpp"
#include "rigidformer_ros/parameters/wildcard.hpp"

namespace rigidformer_ros {

namespace {

using rigidformer::BodyProperties;
using rigidformer::Correspondence;
using rigidformer::CorrespondenceOptions;
using rigidformer::HistoryOptions;
using rigidformer::MotionMode;

constexpr Range kSeconds{0.0, 3600.0};
constexpr Range kPositiveSeconds{1e-3, 3600.0};

void read_properties(ParameterReader& reader, BodyProperties& properties) {
  reader.read("mass", properties.mass_kg, {1e-6, 1e6}, "unknown");
  reader.read("friction", properties.friction, {0.0, 10.0}, "unknown");
  reader.read("restitution", properties.restitution, {0.0, 1.0}, "unknown");
}

void require_text(const ParameterReader& reader, const std::string& key, const std::string& value) {
  if (value.empty()) {
    throw std::invalid_argument("parameter " + reader.path() + "/" + key + ": is missing or empty");
  }
}

MotionMode read_mode(ParameterReader& reader) {
  std::string mode = "dynamic";
  reader.read("mode", mode, {"dynamic", "kinematic", "static"});
  return mode == "static" ? MotionMode::kStatic : mode == "kinematic" ? MotionMode::kKinematic : MotionMode::kDynamic;
}

ListedObject read_listed_object(ParameterReader& reader) {
  ListedObject object;
  reader.read("id", object.id);
  reader.read("topic", object.topic);
  object.mode = read_mode(reader);
  read_properties(reader, object.properties);
  require_text(reader, "id", object.id);
  require_text(reader, "topic", object.topic);
  return object;
}

NamedLabel read_named_label(ParameterReader& reader) {
  NamedLabel named;
  int label = 0;
  reader.read("label", label, {1.0, 2147483647.0});
  reader.read("id", named.id);
  named.mode = read_mode(reader);
  read_properties(reader, named.properties);
  require_text(reader, "id", named.id);
  if (label == 0) {
    throw std::invalid_argument("parameter " + reader.path() + "/label: is missing, must be a number from 1 on");
  }
  named.label = static_cast<std::uint32_t>(label);
  return named;
}

void read_label_names(ParameterReader& reader, std::vector<NamedLabel>& names) {
  std::set<std::uint32_t> labels;
  std::set<std::string> ids;
  reader.list("label_names", [&](ParameterReader& element) {
    names.push_back(read_named_label(element));
    if (!labels.insert(names.back().label).second || !ids.insert(names.back().id).second) {
      throw std::invalid_argument("parameter " + element.path() + ": label " + std::to_string(names.back().label) +
                                  " or id '" + names.back().id + "' is listed twice, both must be unique");
    }
  });
}

void read_input(ParameterReader& reader, InputParameters& input) {
  std::set<std::string> ids;
  std::set<std::string> topics;
  reader.list("objects", [&](ParameterReader& element) {
    input.objects.push_back(read_listed_object(element));
    if (!ids.insert(input.objects.back().id).second) {
      throw std::invalid_argument("parameter " + element.path() + "/id: '" + input.objects.back().id +
                                  "' is listed twice, ids must be unique");
    }
    if (!topics.insert(input.objects.back().topic).second) {
      throw std::invalid_argument("parameter " + element.path() + "/topic: '" + input.objects.back().topic +
                                  "' is listed twice, every object needs its own topic");
    }
  });
  reader.read("object_topics", input.object_topics);
  if (!input.object_topics.empty() && !is_topic_pattern(input.object_topics)) {
    throw std::invalid_argument("parameter " + reader.path() + "/object_topics: is '" + input.object_topics +
                                "', must be a topic name with one '*' as a whole segment, or empty");
  }
  reader.read("discovery_period", input.discovery_period, {0.1, 60.0});
  reader.read("queue_size", input.queue_size, {1, 1000});
  reader.read("min_points", input.min_points, {4, 1e6});
  reader.read("max_points", input.max_points, {4, 1e8});
  reader.read("sync_window", input.sync_window, kSeconds);
  reader.read("cloud", input.cloud);
  reader.read("max_cloud_points", input.max_cloud_points, {4, 1e8});
  read_label_names(reader, input.label_names);
  reader.read("object_clouds", input.object_clouds);
  reader.read("pose_frame_prefix", input.pose_frame_prefix);
}

void read_history(ParameterReader& reader, HistoryOptions& history) {
  reader.read("min_dt", history.min_dt, {1e-4, 1.0});
  reader.read("max_dt", history.max_dt, {1e-3, 10.0});
  reader.read("object_timeout", history.object_timeout, kPositiveSeconds);
  reader.read("jump_threshold", history.jump_threshold, kPositiveSeconds);
  reader.read("max_speed", history.max_speed, {0.01, 1e4});
  reader.read("max_angular_speed", history.max_angular_speed, {0.01, 1e4});
  if (history.min_dt >= history.max_dt) {
    throw std::invalid_argument("parameter " + reader.path() + "/max_dt: is " + std::to_string(history.max_dt) +
                                ", must be greater than min_dt = " + std::to_string(history.min_dt));
  }
}

void read_correspondence(ParameterReader& reader, CorrespondenceOptions& correspondence) {
  std::string method = "ordered";
  reader.read("method", method, {"ordered", "registration", "pose"});
  correspondence.method = to_correspondence(method);
  reader.read("max_rmse", correspondence.max_rmse, {1e-6, 10.0});
  reader.read("noise", correspondence.noise, {1e-6, 1.0});
  reader.read("min_inlier_ratio", correspondence.min_inlier_ratio, {0.0, 1.0});
  reader.read("voxel_size", correspondence.voxel_size, {0.005, 0.5});
  reader.read("max_reference_points", correspondence.max_reference_points, {50, 1e5});
  reader.read("max_correspondence_distance", correspondence.max_correspondence_distance, {0.01, 1.0});
  reader.read("max_iterations", correspondence.max_iterations, {1, 1000});
  reader.read("max_registered_points", correspondence.max_registered_points, {50, 1e5});
  reader.read("max_rotation", correspondence.max_rotation, {0.01, 3.15});
  reader.read("max_failures", correspondence.max_failures, {0, 1000});
}

void read_model(ParameterReader& reader, rigidformer::PredictorOptions& model) {
  reader.read("file", model.file);
  reader.read("device", model.device);
  reader.read("precision", model.precision, {"float32", "bfloat16"});
  reader.read("num_threads", model.num_threads, {1, 256});
  reader.read("warmup_runs", model.warmup_runs, {0, 100});
  reader.read("rest_speed", model.rest_speed, {0.0, 10.0});
  reader.read("rest_spin", model.rest_spin, {0.0, 100.0});
}

void read_predict(ParameterReader& reader, PredictParameters& predict) {
  reader.read("rate", predict.rate, {0.01, 1000.0});
  reader.read("num_steps", predict.num_steps, {1, 10000});
  reader.read("time_step", predict.time_step, {1e-4, 10.0});
  reader.read("gravity", predict.gravity, {-100.0, 0.0});
  reader.read("ground_height", predict.ground_height, {-1e4, 1e4}, "none");
  reader.read("length_scale", predict.length_scale, {1e-4, 1e4}, "auto");
}

void read_service(ParameterReader& reader, ServiceParameters& service) {
  reader.read("max_steps", service.max_steps, {1, 100000});
  reader.read("max_wall_time", service.max_wall_time, kPositiveSeconds);
  reader.read("max_state_age", service.max_state_age, kPositiveSeconds);
  reader.read("max_clients_queued", service.max_clients_queued, {0, 1000});
  reader.read("max_returned_points", service.max_returned_points, {1, 1e8});
  reader.read("settle_linear_speed", service.settle_linear_speed, {0.0, 100.0});
  reader.read("settle_angular_speed", service.settle_angular_speed, {0.0, 100.0});
  reader.read("settle_duration", service.settle_duration, kSeconds);
}

void read_property_parameters(ParameterReader& reader, PropertyParameters& properties) {
  read_properties(reader, properties.defaults);
  reader.list("objects", [&](ParameterReader& element) {
    PropertyRule rule;
    element.read("id", rule.id);
    require_text(element, "id", rule.id);
    read_properties(element, rule.properties);
    properties.objects.push_back(rule);
  });
}

void read_display(ParameterReader& reader, DisplayParameters& display) {
  constexpr Range kMetres{1e-5, 100.0};
  reader.read("markers", display.markers);
  reader.read("ghost_every", display.ghost_every, {1, 100000});
  reader.read("max_ghost_points", display.max_ghost_points, {1, 100000});
  reader.read("point_size", display.point_size, kMetres);
  reader.read("path_width", display.path_width, kMetres);
  reader.read("label_size", display.label_size, kMetres);
  reader.read("marker_lifetime", display.marker_lifetime, kSeconds);
}

void read_diagnostics(ParameterReader& reader, DiagnosticsParameters& diagnostics) {
  reader.read("report_period", diagnostics.report_period, {0.1, 3600.0});
  reader.read("period", diagnostics.period, {0.1, 60.0});
  reader.read("max_input_age", diagnostics.max_input_age, kPositiveSeconds);
  reader.read("max_processing_time", diagnostics.max_processing_time, kPositiveSeconds);
  reader.read("max_consecutive_delay", diagnostics.max_consecutive_delay, kPositiveSeconds);
  reader.read("check_window", diagnostics.check_window, {1.0, 3600.0});
  reader.read("trusted_position_error", diagnostics.trusted_position_error, {0.0, 100.0});
  reader.read("trusted_rotation_error", diagnostics.trusted_rotation_error, {0.0, 3.15});
}

void overlay(BodyProperties& base, const BodyProperties& top) {
  base.mass_kg = top.mass_kg ? top.mass_kg : base.mass_kg;
  base.friction = top.friction ? top.friction : base.friction;
  base.restitution = top.restitution ? top.restitution : base.restitution;
}

}  // namespace

rigidformer::PredictorOptions default_model_options() {
  rigidformer::PredictorOptions options;
  options.file = "package://rigidformer_ros/models/small.safetensors";
  return options;
}

NodeParameters read_parameters(const XmlRpc::XmlRpcValue& tree) {
  NodeParameters p;
  ParameterReader reader(tree, "");
  reader.read("fixed_frame", p.fixed_frame);
  reader.read("tf_timeout", p.tf_timeout, {0.0, 10.0});
  reader.read("max_stamp_skew", p.max_stamp_skew, kPositiveSeconds);
  reader.group("input", [&](ParameterReader& group) { read_input(group, p.input); });
  reader.group("history", [&](ParameterReader& group) { read_history(group, p.history); });
  reader.group("correspondence", [&](ParameterReader& group) { read_correspondence(group, p.correspondence); });
  reader.group("model", [&](ParameterReader& group) { read_model(group, p.model); });
  reader.group("predict", [&](ParameterReader& group) { read_predict(group, p.predict); });
  reader.group("service", [&](ParameterReader& group) { read_service(group, p.service); });
  reader.group("properties", [&](ParameterReader& group) { read_property_parameters(group, p.properties); });
  reader.group("display", [&](ParameterReader& group) { read_display(group, p.display); });
  reader.group("diagnostics", [&](ParameterReader& group) { read_diagnostics(group, p.diagnostics); });
  reader.finish();
  if (p.fixed_frame.empty()) {
    throw std::invalid_argument("parameter fixed_frame: is empty, must name a tf frame with z up");
  }
  return p;
}

Correspondence to_correspondence(const std::string& method) {
  if (method == "ordered") {
    return Correspondence::kOrdered;
  }
  if (method == "registration") {
    return Correspondence::kRegistration;
  }
  if (method == "pose") {
    return Correspondence::kPose;
  }
  throw std::invalid_argument("correspondence method '" + method + "', must be ordered, registration or pose");
}

rigidformer::TrackingOptions tracking_options(const NodeParameters& parameters) {
  return {parameters.input.min_points, parameters.input.sync_window, parameters.predict.length_scale,
          parameters.history, parameters.correspondence};
}

rigidformer::BodyProperties resolve_properties(const PropertyParameters& parameters, const std::string& id,
                                               const rigidformer::BodyProperties& known) {
  rigidformer::BodyProperties properties = parameters.defaults;
  for (const PropertyRule& rule : parameters.objects) {
    if (matches_wildcard(rule.id, id)) {
      overlay(properties, rule.properties);
    }
  }
  overlay(properties, known);
  return properties;
}

void resolve_properties(const PropertyParameters& parameters, rigidformer::ObjectObservation& observation) {
  observation.properties = resolve_properties(parameters, observation.id, observation.properties);
}

}  // namespace rigidformer_ros
