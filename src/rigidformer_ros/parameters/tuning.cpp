// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/parameters/tuning.hpp"

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/console.h>

#include <mutex>
#include <stdexcept>
#include <utility>

#include "rigidformer_ros/parameters/tuning_messages.hpp"

namespace rigidformer_ros {

namespace {

using dynamic_reconfigure::Config;
using dynamic_reconfigure::ConfigDescription;
using dynamic_reconfigure::Reconfigure;

/// The server of one group of parameters. It speaks the messages of dynamic_reconfigure itself: the server of that
/// package wants every parameter, with its range, in a file of its own.
template <class Parameters>
class Group {
 public:
  /// `apply` is called now and whenever `parameters` changed; `mutex` guards them.
  Group(const ros::NodeHandle& private_node, const char* name, std::mutex& mutex, Parameters& parameters,
        std::function<void()> apply)
      : node_(private_node, name),
        mutex_(mutex),
        parameters_(parameters),
        apply_(std::move(apply)),
        descriptions_(node_.advertise<ConfigDescription>("parameter_descriptions", 1, /*latch=*/true)),
        updates_(node_.advertise<Config>("parameter_updates", 1, /*latch=*/true)) {
    const std::lock_guard<std::mutex> lock(mutex_);
    descriptions_.publish(describe_tunable<Parameters>());
    apply_();
    announce();
    service_ = node_.advertiseService("set_parameters", &Group::change, this);
  }

 private:
  bool change(Reconfigure::Request& request, Reconfigure::Response& response) {
    const std::lock_guard<std::mutex> lock(mutex_);
    try {
      take_over(request.config, parameters_);
      apply_();
    } catch (const std::invalid_argument& error) {
      ROS_WARN_STREAM("Reconfiguration of " << node_.getNamespace() << " refused: " << error.what());
    }
    announce();
    response.config = to_config(parameters_);
    return true;
  }

  /// The parameter server and all clients learn what holds.
  void announce() {
    for_each_tunable(parameters_,
                     [this](const char* key, auto& value, const Accepts&, const char*) { node_.setParam(key, value); });
    updates_.publish(to_config(parameters_));
  }

  ros::NodeHandle node_;
  std::mutex& mutex_;
  Parameters& parameters_;
  std::function<void()> apply_;
  ros::Publisher descriptions_;
  ros::Publisher updates_;
  ros::ServiceServer service_;
};

}  // namespace

struct TuningServer::Impl {
  Impl(const ros::NodeHandle& private_node, const NodeParameters& start, const Apply& apply)
      : parameters(start),
        predict(private_node, "predict", mutex, parameters.predict, [this, apply] { apply(parameters); }),
        display(private_node, "display", mutex, parameters.display, [this, apply] { apply(parameters); }),
        diagnostics(private_node, "diagnostics", mutex, parameters.diagnostics, [this, apply] { apply(parameters); }) {}

  std::mutex mutex;
  NodeParameters parameters;
  Group<PredictParameters> predict;
  Group<DisplayParameters> display;
  Group<DiagnosticsParameters> diagnostics;
};

TuningServer::TuningServer(const ros::NodeHandle& private_node, const NodeParameters& parameters, Apply apply)
    : impl_(std::make_unique<Impl>(private_node, parameters, std::move(apply))) {}

TuningServer::~TuningServer() = default;

}  // namespace rigidformer_ros
