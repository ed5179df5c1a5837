// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rigidformer/predictor.hpp"
#include "rigidformer/scene/object.hpp"
#include "rigidformer/tracking/observation.hpp"
#include "rigidformer/tracking/options.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"

namespace rigidformer_ros {

// The node's parameters. A member's name is its YAML key, a member's initial value is the parameter's only default.

/// One object with a topic of its own, an entry of `input/objects`.
struct ListedObject {
  std::string id;
  std::string topic;  ///< sensor_msgs/PointCloud2
  rigidformer::MotionMode mode = rigidformer::MotionMode::kDynamic;
  rigidformer::BodyProperties properties;
};

/// What the points of one label are, an entry of `input/label_names`.
struct NamedLabel {
  std::uint32_t label = 0;
  std::string id;
  rigidformer::MotionMode mode = rigidformer::MotionMode::kDynamic;
  rigidformer::BodyProperties properties;
};

struct InputParameters {
  std::vector<ListedObject> objects;
  std::string object_topics = "/objects/*/points";  ///< One '*' stands for the object's id; "" = only listed objects
  double discovery_period = 1.0;                    ///< [s] wall time between looks for new topics
  int queue_size = 5;                               ///< Clouds kept per topic
  int min_points = 4;                               ///< Finite points below which a cloud is rejected
  int max_points = 200000;                          ///< Finite points of one object above which its cloud is rejected
  double sync_window = 0.1;         ///< [s] an object seen longer ago than this before the newest sits out
  bool drop_invalid_points = true;  ///< Points at 0 0 0 of the sensor, and repeated ones, are none
  std::string cloud;                ///< Topic of a cloud with a label per point; "" = none
  int max_cloud_points = 4000000;   ///< Points of all objects and the background above which it is rejected
  std::string label_field;          ///< Field with the labels; "" = instance, without it label
  std::vector<int> background_labels = {-1, 0};  ///< Labels of no object; -1 = all bits set, as in 255 of 8 bits
  std::vector<NamedLabel> label_names;           ///< Other labels are the dynamic objects obj_<label>
  std::string object_clouds = "object_clouds";   ///< Topic of rigidformer_ros/ObjectClouds; "" = none
  std::string pose_frame_prefix;  ///< tf frame <prefix><id> is the pose of an object; "" = no such frames
};

struct PredictParameters {
  double rate = 10.0;  ///< [Hz] wall-clock limit of the forecast rate
  int num_steps = 24;
  double time_step = 10.0 / 240.0;            ///< [s]
  double gravity = -10.0;                     ///< [m/s^2] vertical acceleration in the fixed frame
  std::optional<double> ground_height = 0.0;  ///< [m] in the fixed frame; none = no ground
  std::optional<double> length_scale = 1.0;   ///< Real length / trained length; auto = from the median object size
};

struct ServiceParameters {
  int max_steps = 500;
  double max_wall_time = 10.0;  ///< [s]
  double max_state_age = 0.5;   ///< [s]
  int max_clients_queued = 4;   ///< Requests that may wait for their turn; more are answered with BUSY
  int max_returned_points = 2000000;
  double settle_linear_speed = 0.02;  ///< [m/s] an object slower than both speeds ...
  double settle_angular_speed = 0.1;  ///< [rad/s]
  double settle_duration = 0.25;      ///< [s] ... for this long is at rest
};

/// Material of the objects whose id matches `id` ('*' matches any text).
struct PropertyRule {
  std::string id;
  rigidformer::BodyProperties properties;
};

struct PropertyParameters {
  rigidformer::BodyProperties defaults;  ///< YAML keys mass [kg], friction, restitution
  std::vector<PropertyRule> objects;     ///< Later rules win, value by value
};

struct DisplayParameters {
  bool markers = true;
  int ghost_every = 6;           ///< Steps between two ghosts
  int max_ghost_points = 200;    ///< Points drawn per ghost
  double point_size = 0.02;      ///< [m]
  double path_width = 0.015;     ///< [m]
  double label_size = 0.15;      ///< [m] text height
  double marker_lifetime = 0.0;  ///< [s] 0 = until replaced
};

struct DiagnosticsParameters {
  double report_period = 5.0;           ///< [s] wall time between two reports on what is missing or rejected
  double period = 1.0;                  ///< [s] wall time between two messages on /diagnostics
  double max_input_age = 1.0;           ///< [s] newest cloud older than this: warning
  double max_processing_time = 0.5;     ///< [s] wall time; a forecast that takes longer: warning
  double max_consecutive_delay = 3.0;   ///< [s] wall time; forecasts too slow for longer than this in a row: error
  double check_window = 60.0;           ///< [s] how long a comparison of forecast and observation counts
  double trusted_position_error = 0.1;  ///< [m] RMSE up to which a horizon is trusted
  double trusted_rotation_error = 0.3;  ///< [rad] likewise
};

/// The checkpoint that ships with the package, the rest as in the core.
rigidformer::PredictorOptions default_model_options();

struct NodeParameters {
  std::string fixed_frame = "world";  ///< z up; clouds are brought into it through tf
  double tf_timeout = 0.1;            ///< [s] wall time to wait for a transform
  double max_stamp_skew = 5.0;        ///< [s] clouds stamped farther from the clock are rejected
  InputParameters input;
  rigidformer::HistoryOptions history;
  rigidformer::CorrespondenceOptions correspondence;
  rigidformer::PredictorOptions model = default_model_options();
  PredictParameters predict;
  ServiceParameters service;
  PropertyParameters properties;
  DisplayParameters display;
  DiagnosticsParameters diagnostics;
};

/// Reads the node's private parameters. Throws std::invalid_argument naming the parameter and what is accepted.
NodeParameters read_parameters(const XmlRpc::XmlRpcValue& tree);

/// The value of `correspondence/method`. Throws std::invalid_argument for another word.
rigidformer::Correspondence to_correspondence(const std::string& method);

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
