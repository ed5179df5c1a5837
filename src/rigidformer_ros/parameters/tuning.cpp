// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/tuning.hpp"

#include <dynamic_reconfigure/server.h>
#include <rigidformer_ros/DiagnosticsConfig.h>
#include <rigidformer_ros/DisplayConfig.h>
#include <rigidformer_ros/PredictConfig.h>
#include <ros/console.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace rigidformer_ros {

namespace {

// These begin with the generated defaults: nothing else sets the state of a group, and copying it unset is undefined.
PredictConfig to_config(const PredictParameters& predict) {
  PredictConfig config = PredictConfig::__getDefault__();
  config.rate = predict.rate;
  config.num_steps = predict.num_steps;
  return config;
}

DisplayConfig to_config(const DisplayParameters& display) {
  DisplayConfig config = DisplayConfig::__getDefault__();
  config.markers = display.markers;
  config.ghost_every = display.ghost_every;
  config.max_ghost_points = display.max_ghost_points;
  config.point_size = display.point_size;
  config.path_width = display.path_width;
  config.label_size = display.label_size;
  config.marker_lifetime = display.marker_lifetime;
  return config;
}

DiagnosticsConfig to_config(const DiagnosticsParameters& diagnostics) {
  DiagnosticsConfig config = DiagnosticsConfig::__getDefault__();
  config.max_input_age = diagnostics.max_input_age;
  config.max_processing_time = diagnostics.max_processing_time;
  config.max_consecutive_delay = diagnostics.max_consecutive_delay;
  config.trusted_position_error = diagnostics.trusted_position_error;
  config.trusted_rotation_error = diagnostics.trusted_rotation_error;
  return config;
}

// Clamping lets NaN pass.
double finite(double value, const char* name) {
  if (!std::isfinite(value)) {
    throw std::invalid_argument(std::string(name) + ": must be a finite number");
  }
  return value;
}

void take_over(const PredictConfig& config, PredictParameters& predict) {
  predict.rate = finite(config.rate, "predict/rate");
  predict.num_steps = config.num_steps;
}

void take_over(const DisplayConfig& config, DisplayParameters& display) {
  display.markers = config.markers;
  display.ghost_every = config.ghost_every;
  display.max_ghost_points = config.max_ghost_points;
  display.point_size = finite(config.point_size, "display/point_size");
  display.path_width = finite(config.path_width, "display/path_width");
  display.label_size = finite(config.label_size, "display/label_size");
  display.marker_lifetime = finite(config.marker_lifetime, "display/marker_lifetime");
}

void take_over(const DiagnosticsConfig& config, DiagnosticsParameters& diagnostics) {
  diagnostics.max_input_age = finite(config.max_input_age, "diagnostics/max_input_age");
  diagnostics.max_processing_time = finite(config.max_processing_time, "diagnostics/max_processing_time");
  diagnostics.max_consecutive_delay = finite(config.max_consecutive_delay, "diagnostics/max_consecutive_delay");
  diagnostics.trusted_position_error = finite(config.trusted_position_error, "diagnostics/trusted_position_error");
  diagnostics.trusted_rotation_error = finite(config.trusted_rotation_error, "diagnostics/trusted_rotation_error");
}

/// One group of parameters.
template <class Config, class Parameters>
class Group {
 public:
  /// `apply` is called whenever `parameters` changed.
  Group(const ros::NodeHandle& private_node, const char* name, Parameters& parameters, std::function<void()> apply)
      : parameters_(parameters), apply_(std::move(apply)), server_(mutex_, ros::NodeHandle(private_node, name)) {
    // What was read at the start wins over what the server made of it.
    server_.setConfigDefault(to_config(Parameters()));
    server_.updateConfig(to_config(parameters));
    server_.setCallback([this](Config& config, std::uint32_t) { change(config); });
  }

 private:
  void change(Config& config) {
    Parameters changed = parameters_;
    try {
      take_over(config, changed);
    } catch (const std::invalid_argument& error) {
      ROS_WARN_STREAM("Reconfiguration refused: " << error.what());
      config = to_config(parameters_);
      return;
    }
    parameters_ = changed;
    apply_();
  }

  Parameters& parameters_;
  std::function<void()> apply_;
  boost::recursive_mutex mutex_;
  dynamic_reconfigure::Server<Config> server_;
};

}  // namespace

struct TuningServer::Impl {
  Impl(const ros::NodeHandle& private_node, const NodeParameters& start, const Apply& apply)
      : parameters(start),
        predict(private_node, "predict", parameters.predict, [this, apply] { apply(parameters); }),
        display(private_node, "display", parameters.display, [this, apply] { apply(parameters); }),
        diagnostics(private_node, "diagnostics", parameters.diagnostics, [this, apply] { apply(parameters); }) {}

  NodeParameters parameters;
  Group<PredictConfig, PredictParameters> predict;
  Group<DisplayConfig, DisplayParameters> display;
  Group<DiagnosticsConfig, DiagnosticsParameters> diagnostics;
};

TuningServer::TuningServer(const ros::NodeHandle& private_node, const NodeParameters& parameters, Apply apply)
    : impl_(std::make_unique<Impl>(private_node, parameters, std::move(apply))) {}

TuningServer::~TuningServer() = default;

}  // namespace rigidformer_ros
