// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rigidformer/io/members.hpp"
#include "rigidformer/predictor.hpp"
#include "rigidformer/scene/object.hpp"
#include "rigidformer/tracking/observation.hpp"
#include "rigidformer/tracking/options.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/parameters/service_parameters.hpp"

namespace rigidformer_ros {

// The node's parameters: every struct with the table of its members. A member's name is its YAML key, its initial value
// the parameter's only default.

using rigidformer::Accepts;
using rigidformer::anything;
using rigidformer::between;
using rigidformer::one_of;
using rigidformer::share;

/// The keys of a material, beside those of what has it.
template <typename Visit>
void for_each_property(rigidformer::BodyProperties& o, const Visit& visit) {
  visit("mass", o.mass_kg, between(1e-6, 1e6).or_word("unknown"), "[kg] of objects about which nothing else is known");
  visit("friction", o.friction, between(0.0, 10.0).or_word("unknown"), "likewise");
  visit("restitution", o.restitution, share().or_word("unknown"), "likewise");
}

/// One object with a topic of its own, an entry of `input/objects`.
struct ListedObject {
  std::string id;
  std::string topic;  ///< sensor_msgs/PointCloud2
  rigidformer::MotionMode mode = rigidformer::MotionMode::kDynamic;
  rigidformer::BodyProperties properties;
};

template <typename Visit>
void for_each_member(ListedObject& o, const Visit& visit) {
  visit("id", o.id, anything(), "unique name");
  visit("topic", o.topic, anything(), "of its clouds, unique");
  visit("mode", o.mode, anything(), "predicted, keeping its twist, or never moving");
  for_each_property(o.properties, visit);
}

/// What the points of one label are, an entry of `input/label_names`.
struct NamedLabel {
  std::uint32_t label = 0;
  std::string id;
  rigidformer::MotionMode mode = rigidformer::MotionMode::kDynamic;
  rigidformer::BodyProperties properties;
};

template <typename Visit>
void for_each_member(NamedLabel& o, const Visit& visit) {
  visit("label", o.label, between(1, 2147483647), "value in the cloud, unique");
  visit("id", o.id, anything(), "unique name");
  visit("mode", o.mode, anything(), "predicted, keeping its twist, or never moving");
  for_each_property(o.properties, visit);
}

struct InputParameters {
  std::vector<ListedObject> objects;
  std::string object_topics = "/objects/*/points";
  double discovery_period = 1.0;
  int queue_size = 5;
  int min_points = 4;
  int max_points = 200000;
  double sync_window = 0.1;
  bool drop_invalid_points = true;
  std::string cloud;
  int max_cloud_points = 4000000;
  std::string label_field;
  std::vector<int> background_labels = {-1, 0};
  std::vector<NamedLabel> label_names;
  std::string object_clouds = "object_clouds";
  std::string pose_frame_prefix;
};

template <typename Visit>
void for_each_member(InputParameters& o, const Visit& visit) {
  visit("objects", o.objects, anything(), "objects with a topic of their own");
  visit("object_topics", o.object_topics, anything(),
        "pattern of topics found while running; \"\" = only those listed");
  visit("discovery_period", o.discovery_period, between(0.1, 60.0), "[s] wall time between looks for new topics");
  visit("queue_size", o.queue_size, between(1, 1000), "clouds kept per topic");
  visit("min_points", o.min_points, between(4, 1e6), "a cloud with fewer finite points is rejected");
  visit("max_points", o.max_points, between(4, 1e8), "a cloud of one object with more finite points is rejected");
  visit("sync_window", o.sync_window, between(0.0, 3600.0), "[s] objects seen longer before the newest one sit out");
  visit("drop_invalid_points", o.drop_invalid_points, anything(),
        "points at 0 0 0 of the sensor, and one value that many share, are none");
  visit("cloud", o.cloud, anything(), "topic of one labelled cloud of the whole scene; \"\" = none");
  visit("max_cloud_points", o.max_cloud_points, between(4, 1e8),
        "more finite points in it, background included: it is rejected");
  visit("label_field", o.label_field, anything(), "field with the labels; \"\" = `instance`, or else `label`");
  visit("background_labels", o.background_labels, between(-1, 2147483647),
        "labels of no object; -1 = all bits set, as in 255 of an 8-bit field");
  visit("label_names", o.label_names, anything(), "what labels mean; others are dynamic objects `obj_<label>`");
  visit("object_clouds", o.object_clouds, anything(), "topic of rigidformer_ros/ObjectClouds; \"\" = none");
  visit("pose_frame_prefix", o.pose_frame_prefix, anything(), "tf frames `<prefix><id>` are poses of a tracker");
}

/// Those of the predictor's options that are parameters of the node.
struct ModelParameters : rigidformer::PredictorOptions {
  ModelParameters() { file = "package://rigidformer_ros/models/hybrid.safetensors"; }
};

template <typename Visit>
void for_each_member(ModelParameters& o, const Visit& visit) {
  visit("file", o.file, anything(), "checkpoint");
  visit("device", o.device, anything(), "auto, cpu, cuda or cuda:N; auto = a usable GPU, else the CPU");
  visit("precision", o.precision, one_of({"float32", "bfloat16"}), "of the network");
  visit("num_threads", o.num_threads, between(1, 256), "CPU threads for tensor operations");
  visit("warmup_runs", o.warmup_runs, between(0, 100), "predictions made before the node says ready");
  visit("rest_speed", o.rest_speed, between(-1.0, 10.0),
        "[m/s] slower objects are held still; 0 = never, negative = as the model says");
  visit("rest_spin", o.rest_spin, between(-1.0, 100.0), "[rad/s] so are those that turn slower; likewise");
}

struct PredictParameters {
  double rate = 10.0;
  int num_steps = 24;
  double time_step = 10.0 / 240.0;
  double gravity = -10.0;
  std::optional<double> ground_height = 0.0;  ///< None = no ground
  std::optional<double> ground_friction;      ///< None = unknown
  std::optional<double> ground_restitution;   ///< None = unknown
  std::optional<double> length_scale = 1.0;   ///< None = from the median object size
  int num_particles = 1;
};

template <typename Visit>
void for_each_member(PredictParameters& o, const Visit& visit) {
  visit("rate", o.rate, between(0.01, 1000.0).tunable(), "[Hz] wall-clock limit of the forecast rate");
  visit("num_steps", o.num_steps, between(1, 10000).tunable(), "steps of a forecast");
  visit("time_step", o.time_step, between(1e-4, 10.0), "[s] or the nearest trained one, at `length_scale`");
  visit("gravity", o.gravity, between(-100.0, 0.0), "[m/s²] along z of the fixed frame");
  visit("ground_height", o.ground_height, between(-1e4, 1e4).or_word("none"), "[m] in the fixed frame");
  visit("ground_friction", o.ground_friction, between(0.0, 1000.0).or_word("unknown"),
        "friction, which counts times that of the object");
  visit("ground_restitution", o.ground_restitution, between(0.0, 1.0).or_word("unknown"), "restitution; likewise");
  visit("length_scale", o.length_scale, between(1e-4, 1e4).or_word("auto"),
        "real length / trained length; auto = from the objects");
  visit("num_particles", o.num_particles, between(1, 64),
        "worlds among which unknown material is drawn, for standard deviations; 1 = none");
}

/// Material of the objects whose id matches `id` ('*' matches any text).
struct PropertyRule {
  std::string id;
  rigidformer::BodyProperties properties;
};

template <typename Visit>
void for_each_member(PropertyRule& o, const Visit& visit) {
  visit("id", o.id, anything(), "of the objects; `*` is any text");
  for_each_property(o.properties, visit);
}

struct PropertyParameters {
  rigidformer::BodyProperties defaults;
  std::vector<PropertyRule> objects;
};

template <typename Visit>
void for_each_member(PropertyParameters& o, const Visit& visit) {
  for_each_property(o.defaults, visit);
  visit("objects", o.objects, anything(), "rules by `id`, in which `*` is any text; later ones win, value by value");
}

struct DisplayParameters {
  bool markers = true;
  int ghost_every = 6;
  int max_ghost_points = 200;
  double point_size = 0.02;
  double path_width = 0.015;
  double label_size = 0.15;
  double marker_lifetime = 0.0;
};

template <typename Visit>
void for_each_member(DisplayParameters& o, const Visit& visit) {
  const Accepts metres = between(1e-5, 100.0).tunable();
  visit("markers", o.markers, anything().tunable(), "whether markers are published");
  visit("ghost_every", o.ghost_every, between(1, 100000).tunable(), "steps between two ghosts");
  visit("max_ghost_points", o.max_ghost_points, between(1, 100000).tunable(), "points drawn per ghost");
  visit("point_size", o.point_size, metres, "[m] of a ghost's points");
  visit("path_width", o.path_width, metres, "[m] of a path");
  visit("label_size", o.label_size, metres, "[m] height of the text");
  visit("marker_lifetime", o.marker_lifetime, between(0.0, 3600.0).tunable(), "[s] 0 = until replaced");
}

struct DiagnosticsParameters {
  double report_period = 5.0;
  double period = 1.0;
  double max_input_age = 1.0;
  double max_processing_time = 0.5;
  double max_consecutive_delay = 3.0;
  double check_window = 60.0;
  double trusted_position_error = 0.1;  ///< Root mean square
  double trusted_rotation_error = 0.3;  ///< Root mean square
};

template <typename Visit>
void for_each_member(DiagnosticsParameters& o, const Visit& visit) {
  const Accepts duration = between(1e-3, 3600.0).tunable();
  visit("report_period", o.report_period, between(0.1, 3600.0), "[s] wall time between two reports in the log");
  visit("period", o.period, between(0.1, 60.0), "[s] wall time between two messages on `/diagnostics`");
  visit("max_input_age", o.max_input_age, duration, "[s] an older newest cloud is a warning");
  visit("max_processing_time", o.max_processing_time, duration, "[s] wall time; a slower forecast is a warning");
  visit("max_consecutive_delay", o.max_consecutive_delay, duration,
        "[s] wall time; slow forecasts for longer in a row are an error");
  visit("check_window", o.check_window, between(1.0, 3600.0), "[s] how long a comparison of the self-check counts");
  visit("trusted_position_error", o.trusted_position_error, between(0.0, 100.0).tunable(),
        "[m] error up to which a horizon is trusted ...");
  visit("trusted_rotation_error", o.trusted_rotation_error, between(0.0, 3.15).tunable(), "[rad] ... in both");
}

struct NodeParameters {
  std::string fixed_frame = "world";
  double tf_timeout = 0.1;
  double max_stamp_skew = 5.0;
  InputParameters input;
  rigidformer::HistoryOptions history;
  rigidformer::CorrespondenceOptions correspondence;
  ModelParameters model;
  PredictParameters predict;
  ServiceParameters service;
  PropertyParameters properties;
  DisplayParameters display;
  DiagnosticsParameters diagnostics;
};

template <typename Visit>
void for_each_member(NodeParameters& o, const Visit& visit) {
  visit("fixed_frame", o.fixed_frame, anything(), "tf frame of the forecasts, z up");
  visit("tf_timeout", o.tf_timeout, between(0.0, 10.0), "[s] wall time to wait for a transform");
  visit("max_stamp_skew", o.max_stamp_skew, between(1e-3, 3600.0),
        "[s] clouds stamped farther from the clock are rejected");
  visit("input", o.input, anything(), "what the node listens to");
  visit("history", o.history, anything(), "when a track goes on and when another begins");
  visit("correspondence", o.correspondence, anything(), "how poses are found and judged");
  visit("model", o.model, anything(), "the network");
  visit("predict", o.predict, anything(), "the forecasts");
  visit("service", o.service, anything(), "limits of requests");
  visit("properties", o.properties, anything(), "material of objects");
  visit("display", o.display, anything(), "markers");
  visit("diagnostics", o.diagnostics, anything(), "when to warn, and what is trusted");
}

/// Reads the node's private parameters. Throws std::invalid_argument naming the parameter and what is accepted.
NodeParameters read_parameters(const XmlRpc::XmlRpcValue& tree);

/// Limits of clouds with the names of their parameters.
PointLimit max_points_per_object(const InputParameters& input);
PointLimit max_points_per_cloud(const InputParameters& input);

/// What the parameters say about tracks.
rigidformer::TrackingOptions tracking_options(const NodeParameters& parameters);

/// Material of object `id`: `known` where it says something, else the rules, else the defaults.
rigidformer::BodyProperties resolve_properties(const PropertyParameters& parameters, const std::string& id,
                                               const rigidformer::BodyProperties& known);

/// Completes what an observation says about the material of its object.
void resolve_properties(const PropertyParameters& parameters, rigidformer::ObjectObservation& observation);

}  // namespace rigidformer_ros
