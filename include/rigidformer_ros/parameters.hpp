// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <optional>
#include <string>
#include <vector>

#include "rigidformer/predictor.hpp"
#include "rigidformer/scene/object.hpp"

namespace rigidformer_ros {

// The node's parameters. A member's name is its YAML key, a member's initial value is the parameter's only default.

/// One object with a topic of its own, an entry of `input/objects`.
struct ListedObject {
  std::string id;
  std::string topic;  ///< sensor_msgs/PointCloud2
  rigidformer::MotionMode mode = rigidformer::MotionMode::kDynamic;
  rigidformer::PhysicalProperties properties;
};

struct InputParameters {
  std::vector<ListedObject> objects;
  std::string object_topics = "/objects/*/points";  ///< One '*' stands for the object's id; "" = only listed objects
  double discovery_period = 1.0;                    ///< [s] wall time between looks for new topics
  int queue_size = 5;                               ///< Clouds kept per topic
  int min_points = 4;                               ///< Finite points below which a cloud is rejected
  int max_points = 200000;                          ///< Points above which a cloud is rejected
  double sync_window = 0.1;  ///< [s] an object seen longer ago than this before the newest sits out
};

struct HistoryParameters {
  double min_dt = 0.005;            ///< [s] clouds closer than this replace each other
  double max_dt = 0.3;              ///< [s] a gap longer than this restarts the track
  double object_timeout = 1.0;      ///< [s] objects unseen for longer are forgotten
  double jump_threshold = 0.5;      ///< [s] stamps this far back mean that time restarted; less is a late cloud
  double max_speed = 20.0;          ///< [m/s] faster than this is another object under the same id: new track
  double max_angular_speed = 80.0;  ///< [rad/s] likewise
};

struct CorrespondenceParameters {
  std::string method = "ordered";  ///< ordered: same points in the same order in every cloud
  double max_rmse = 0.02;          ///< [m] above this the observed pose counts as LOW_QUALITY
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
  rigidformer::PhysicalProperties properties;
};

struct PropertyParameters {
  rigidformer::PhysicalProperties defaults;  ///< YAML keys mass [kg], friction, restitution
  std::vector<PropertyRule> objects;         ///< Later rules win, value by value
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
  HistoryParameters history;
  CorrespondenceParameters correspondence;
  rigidformer::PredictorOptions model = default_model_options();
  PredictParameters predict;
  ServiceParameters service;
  PropertyParameters properties;
  DisplayParameters display;
  DiagnosticsParameters diagnostics;
};

/// Reads the node's private parameters. Throws std::invalid_argument naming the parameter and what is accepted.
NodeParameters read_parameters(const XmlRpc::XmlRpcValue& tree);

/// Material of object `id`: `known` where it says something, else the rules, else the defaults.
rigidformer::PhysicalProperties resolve_properties(const PropertyParameters& parameters, const std::string& id,
                                                   const rigidformer::PhysicalProperties& known);

}  // namespace rigidformer_ros
