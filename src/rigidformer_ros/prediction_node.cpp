// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/prediction_node.hpp"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/package.h>

#include <string>
#include <utility>

#include "rigidformer_ros/cloud_conversion.hpp"
#include "rigidformer_ros/process_end.hpp"

namespace rigidformer_ros {

PredictionNode::Lane::Lane() : spinner(1, &queue) { node.setCallbackQueue(&queue); }

PredictionNode::PredictionNode(const NodeParameters& parameters, PredictorFactory make_predictor)
    : parameters_(parameters),
      frames_(parameters.fixed_frame, parameters.tf_timeout),
      live_scene_(parameters, rejections_),
      forecaster_(parameters, std::move(make_predictor)),
      publisher_(forecast_lane_.node, parameters),
      service_(service_lane_.node, parameters, forecaster_, live_scene_, frames_),
      inputs_(input_lane_.node, parameters.input,
              [this](const ListedObject& source, const sensor_msgs::PointCloud2& cloud) { on_cloud(source, cloud); }) {
  // Wall timers: they also run while a simulated clock stands still.
  forecast_timer_ = forecast_lane_.node.createWallTimer(ros::WallDuration(1.0 / parameters_.predict.rate),
                                                        [this](const ros::WallTimerEvent&) { on_forecast_timer(); });
  report_timer_ = input_lane_.node.createWallTimer(ros::WallDuration(parameters_.diagnostics.report_period),
                                                   [this](const ros::WallTimerEvent&) { on_report_timer(); });
  input_lane_.spinner.start();
  forecast_lane_.spinner.start();
  service_lane_.spinner.start();
}

PredictionNode::~PredictionNode() {
  stop();
  service_lane_.spinner.stop();
  forecast_lane_.spinner.stop();
  input_lane_.spinner.stop();
}

// An exception that leaves a subscriber or timer callback would end the node.
void PredictionNode::on_cloud(const ListedObject& source, const sensor_msgs::PointCloud2& cloud) {
  try {
    take_in(source, cloud);
  } catch (const std::invalid_argument& error) {
    rejections_.add("malformed cloud", source.topic + ": " + error.what());
  } catch (const TransformError& error) {
    rejections_.add("no transform", source.topic + ": " + error.what());
  } catch (const std::exception& error) {
    rejections_.add("failed cloud", source.topic + ": " + error.what());
  }
}

void PredictionNode::take_in(const ListedObject& source, const sensor_msgs::PointCloud2& cloud) {
  if (!live_scene_.accepts(source.id, cloud.header.stamp, ros::Time::now())) {
    return;
  }
  const Points points = read_points(cloud, static_cast<std::uint64_t>(parameters_.input.max_points));
  const RigidTransform T_fixed_cloud = frames_.T_fixed_from(cloud.header.frame_id, cloud.header.stamp);
  ObjectObservation observation;
  observation.id = source.id;
  observation.stamp = cloud.header.stamp;
  observation.points_world = T_fixed_cloud.apply(points);
  observation.mode = source.mode;
  observation.properties = resolve_properties(parameters_.properties, source.id, source.properties);
  live_scene_.add(observation);
}

void PredictionNode::on_forecast_timer() {
  try {
    forecast_newest_scene();
  } catch (const std::exception& error) {
    rejections_.add("failed forecast", error.what());
  }
}

void PredictionNode::forecast_newest_scene() {
  const ros::Time now = ros::Time::now();
  live_scene_.watch_clock(now);
  if (!forecaster_.ready()) {
    return;
  }
  if (!reported_ready_) {
    reported_ready_ = true;
    ROS_INFO("Ready: the model is loaded and warmed up.");
  }
  ObservedScene scene = live_scene_.snapshot(parameters_.predict.time_step);
  const bool outdated = (now - scene.stamp).toSec() > parameters_.history.object_timeout;
  if (scene.objects.empty() || outdated) {
    publisher_.clear();
    last_forecast_size_ = 0;
    return;
  }
  if (scene.stamp == last_forecast_stamp_ && scene.objects.size() == last_forecast_size_) {
    return;
  }
  last_forecast_stamp_ = scene.stamp;
  last_forecast_size_ = scene.objects.size();
  publisher_.publish(forecaster_.roll_out(std::move(scene), forecaster_.default_settings()));
}

void PredictionNode::on_report_timer() {
  if (!forecaster_.ready()) {
    ROS_WARN_STREAM("Not ready: " << forecaster_.message());
  }
  if (ros::Time::now().isZero()) {
    ROS_WARN("Waiting for the clock: use_sim_time is set, but nothing publishes /clock.");
  } else if (live_scene_.snapshot(parameters_.predict.time_step).objects.empty()) {
    ROS_WARN_STREAM("Waiting for usable clouds on " << inputs_.describe());
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

int run_prediction_node(const ModelLoader& make_predictor) {
  try {
    XmlRpc::XmlRpcValue tree;
    ros::NodeHandle("~").getParam("", tree);
    const NodeParameters parameters = read_parameters(tree);
    ShutdownLimit limit;
    PredictionNode node(parameters, [&] { return make_predictor(parameters.model); });
    const int exit_code = wait_for_end();
    limit.start(exit_code);
    node.stop();
    ros::waitForShutdown();  // ROS waits for callbacks in progress
    return exit_code;
  } catch (const std::invalid_argument& error) {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
}

}  // namespace rigidformer_ros
