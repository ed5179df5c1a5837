// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/prediction_node.hpp"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/package.h>

#include <string>
#include <utility>

#include "rigidformer_ros/process_end.hpp"

namespace rigidformer_ros {

PredictionNode::Lane::Lane(const ros::NodeHandle& parent, std::uint32_t num_threads)
    : node(parent), spinner(num_threads, &queue) {
  node.setCallbackQueue(&queue);
}

PredictionNode::PredictionNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                               const NodeParameters& parameters, PredictorFactory make_predictor)
    : parameters_(parameters),
      frames_(parameters.fixed_frame, parameters.tf_timeout, node),
      live_scene_(parameters, rejections_),
      intake_(parameters,
              [this](const std::string& frame_id, const ros::Time& stamp, double timeout_s) {
                return frames_.T_fixed_from(frame_id, stamp, timeout_s);
              },
              {live_scene_, rejections_, input_monitor_, timing_}),
      forecaster_(parameters, std::move(make_predictor)),
      input_lane_(node),
      forecast_lane_(node),
      service_lane_(node, RolloutService::num_threads(parameters.service)),
      health_lane_(node),
      forecast_loop_(forecast_lane_.node, parameters,
                     {live_scene_, forecaster_, rejections_, input_monitor_, timing_, quality_}),
      service_(service_lane_.node, parameters, forecaster_, live_scene_, frames_, quality_),
      inputs_(input_lane_.node, parameters.input,
              [this](const ListedObject& source, const sensor_msgs::PointCloud2& cloud) {
                intake_.take_object(source, cloud);
              }),
      scene_inputs_(
          input_lane_.node, parameters.input,
          {[this](const std::string& topic, const sensor_msgs::PointCloud2& cloud) {
             intake_.take_labelled(topic, cloud);
           },
           [this](const std::string& topic, const ObjectClouds& clouds) { intake_.take_scene(topic, clouds); }}),
      diagnostics_(health_lane_.node, private_node, parameters.diagnostics,
                   {forecaster_, rejections_, input_monitor_, timing_, quality_}) {
  ros::NodeHandle tuning_node(private_node);
  tuning_node.setCallbackQueue(&health_lane_.queue);
  tuning_ = std::make_unique<TuningServer>(tuning_node, parameters, [this](const NodeParameters& p) { tune(p); });
  // Wall timers: they also run while a simulated clock stands still.
  report_timer_ = input_lane_.node.createWallTimer(ros::WallDuration(parameters_.diagnostics.report_period),
                                                   [this](const ros::WallTimerEvent&) { on_report_timer(); });
  for (Lane* lane : {&input_lane_, &forecast_lane_, &service_lane_, &health_lane_}) {
    lane->spinner.start();
  }
}

PredictionNode::~PredictionNode() {
  stop();
  for (Lane* lane : {&health_lane_, &service_lane_, &forecast_lane_, &input_lane_}) {
    lane->spinner.stop();
  }
}

void PredictionNode::tune(const NodeParameters& parameters) {
  forecaster_.set_num_steps(parameters.predict.num_steps);
  forecast_loop_.tune(parameters);
  diagnostics_.tune(parameters.diagnostics);
}

void PredictionNode::on_report_timer() {
  if (!forecaster_.ready()) {
    ROS_WARN_STREAM("Not ready: " << forecaster_.message());
  }
  if (ros::Time::now().isZero()) {
    ROS_WARN("Waiting for the clock: use_sim_time is set, but nothing publishes /clock.");
  } else if (live_scene_.snapshot(parameters_.predict.time_step).objects.empty()) {
    const std::string scenes = scene_inputs_.describe();
    ROS_WARN_STREAM("Waiting for usable clouds on " << inputs_.describe() << (scenes.empty() ? "" : ", ") << scenes);
  }
  for (const std::string& line : rejections_.take_report()) {
    ROS_WARN_STREAM("Rejected, " << line);
  }
}

namespace {

// package://NAME/PATH is a file of a ROS package; everything else is a path.
std::string resolve_file(const std::string& file) {
  const std::string scheme = "package://";
  if (file.compare(0, scheme.size(), scheme) != 0) {
    return file;
  }
  const std::size_t slash = file.find('/', scheme.size());
  const std::string package = file.substr(scheme.size(), slash - scheme.size());
  const std::string folder = ros::package::getPath(package);
  if (slash == std::string::npos || folder.empty()) {
    throw std::runtime_error("model/file: '" + file + "' names no file of a known ROS package");
  }
  return folder + file.substr(slash);
}

}  // namespace

std::unique_ptr<rigidformer::Predictor> load_model(const rigidformer::PredictorOptions& options) {
  rigidformer::PredictorOptions resolved = options;
  resolved.file = resolve_file(options.file);
  return std::make_unique<rigidformer::Predictor>(resolved);
}

std::unique_ptr<PredictionNode> make_prediction_node(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                                     const ModelLoader& make_predictor) {
  XmlRpc::XmlRpcValue tree;
  private_node.getParam("", tree);
  const NodeParameters parameters = read_parameters(tree);
  return std::make_unique<PredictionNode>(node, private_node, parameters,
                                          [make_predictor, model = parameters.model] { return make_predictor(model); });
}

int run_prediction_node(const ModelLoader& make_predictor) {
  // Beyond the try block: the end of the last handle shuts ROS down, and with it what would print the message below.
  const ros::NodeHandle public_handle, private_handle("~");
  try {
    ShutdownLimit limit;
    catch_interrupt();
    const auto node = make_prediction_node(public_handle, private_handle, make_predictor);
    const int exit_code = wait_for_end();
    limit.start(exit_code);
    node->stop();
    ros::shutdown();  // Waits for callbacks in progress
    return exit_code;
  } catch (const std::invalid_argument& error) {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
}

}  // namespace rigidformer_ros
