// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/node/prediction_node.hpp"

#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/package.h>
#include <ros/spinner.h>
#include <ros/wall_timer.h>

#include <string>
#include <utility>

#include "rigidformer_ros/forecast/scene_forecaster.hpp"
#include "rigidformer_ros/health/diagnostics.hpp"
#include "rigidformer_ros/health/forecast_check.hpp"
#include "rigidformer_ros/health/input_monitor.hpp"
#include "rigidformer_ros/health/rejection_log.hpp"
#include "rigidformer_ros/health/shared_value.hpp"
#include "rigidformer_ros/health/timing_monitor.hpp"
#include "rigidformer_ros/inputs/frame_transformer.hpp"
#include "rigidformer_ros/inputs/live_scene.hpp"
#include "rigidformer_ros/inputs/object_topics.hpp"
#include "rigidformer_ros/inputs/scene_intake.hpp"
#include "rigidformer_ros/inputs/scene_topics.hpp"
#include "rigidformer_ros/node/process_end.hpp"
#include "rigidformer_ros/outputs/candidate_display.hpp"
#include "rigidformer_ros/outputs/forecast_loop.hpp"
#include "rigidformer_ros/parameters/parameters.hpp"
#include "rigidformer_ros/parameters/tuning.hpp"
#include "rigidformer_ros/services/batch_service.hpp"
#include "rigidformer_ros/services/rollout_service.hpp"

namespace rigidformer_ros {

namespace {

/// A node handle with a callback queue and threads of its own. With one thread, its callbacks run one at a time.
struct Lane {
  explicit Lane(const ros::NodeHandle& parent, std::uint32_t num_threads = 1)
      : node(parent), spinner(num_threads, &queue) {
    node.setCallbackQueue(&queue);
  }

  ros::CallbackQueue queue;
  ros::NodeHandle node;
  ros::AsyncSpinner spinner;
};

}  // namespace

/// The parts of the node. Later parts use earlier ones, so their order is that of construction.
struct PredictionNode::Parts {
  Parts(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const NodeParameters& parameters,
        PredictorFactory make_predictor);
  ~Parts();

  void report_what_is_missing();
  void tune(const NodeParameters& parameters);

  NodeParameters parameters;
  RejectionLog rejections;
  InputMonitor input_monitor;
  TimingMonitor timing;
  SharedValue<ForecastQuality> quality;
  FrameTransformer frames;
  LiveScene live_scene;
  SceneIntake intake;
  SceneForecaster forecaster;
  Lane input_lane;
  Lane forecast_lane;
  Lane service_lane;
  Lane health_lane;
  ForecastLoop forecast_loop;
  ClientCount clients;
  RolloutService service;
  BatchAnswerer batches;
  CandidateDisplay candidate_display;
  BatchService batch_service;
  ObjectTopics object_topics;
  SceneTopics scene_topics;
  NodeDiagnostics diagnostics;
  std::unique_ptr<TuningServer> tuning;
  ros::WallTimer report_timer;
};

PredictionNode::Parts::Parts(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const NodeParameters& p,
                             PredictorFactory make_predictor)
    : parameters(p),
      frames(p.fixed_frame, p.tf_timeout, node),
      live_scene(p, rejections),
      intake(p,
             [this](const std::string& frame_id, const ros::Time& stamp, double timeout_s) {
               return frames.T_fixed_from(frame_id, stamp, timeout_s);
             },
             {live_scene, rejections, input_monitor, timing}),
      forecaster(p, std::move(make_predictor)),
      input_lane(node),
      forecast_lane(node),
      service_lane(node, RolloutService::num_threads(p.service)),
      health_lane(node),
      forecast_loop(forecast_lane.node, p, {live_scene, forecaster, rejections, input_monitor, timing, quality}),
      service(service_lane.node, p, forecaster, live_scene, frames, quality, clients),
      batches(p, forecaster, live_scene, frames, clients),
      candidate_display(service_lane.node, p.display),
      batch_service(
          service_lane.node, batches,
          [this](const BatchRequest& request, const BatchResult& result) { candidate_display.show(request, result); }),
      object_topics(input_lane.node, p.input,
                    [this](const ListedObject& source, const sensor_msgs::PointCloud2& cloud) {
                      intake.take_object(source, cloud);
                    }),
      scene_topics(
          input_lane.node, p.input,
          {[this](const std::string& topic, const sensor_msgs::PointCloud2& cloud) {
             intake.take_labelled(topic, cloud);
           },
           [this](const std::string& topic, const ObjectClouds& clouds) { intake.take_scene(topic, clouds); }}),
      diagnostics(health_lane.node, private_node, p.diagnostics,
                  {forecaster, rejections, input_monitor, timing, quality}) {
  ros::NodeHandle tuning_node(private_node);
  tuning_node.setCallbackQueue(&health_lane.queue);
  tuning = std::make_unique<TuningServer>(tuning_node, p, [this](const NodeParameters& tuned) { tune(tuned); });
  // The report needs a wall timer, which also runs while a simulated clock stands still.
  report_timer = input_lane.node.createWallTimer(ros::WallDuration(p.diagnostics.report_period),
                                                 [this](const ros::WallTimerEvent&) { report_what_is_missing(); });
  for (Lane* lane : {&input_lane, &forecast_lane, &service_lane, &health_lane}) {
    lane->spinner.start();
  }
}

PredictionNode::Parts::~Parts() {
  forecaster.stop();
  for (Lane* lane : {&health_lane, &service_lane, &forecast_lane, &input_lane}) {
    lane->spinner.stop();
  }
}

void PredictionNode::Parts::tune(const NodeParameters& tuned) {
  forecaster.set_num_steps(tuned.predict.num_steps);
  forecast_loop.tune(tuned);
  diagnostics.tune(tuned.diagnostics);
}

void PredictionNode::Parts::report_what_is_missing() {
  if (!forecaster.ready()) {
    ROS_WARN_STREAM("Not ready: " << forecaster.message());
  }
  if (ros::Time::now().isZero()) {
    ROS_WARN("Waiting for the clock: use_sim_time is set, but nothing publishes /clock.");
  } else if (live_scene.snapshot(parameters.predict.time_step).objects.empty()) {
    const std::string scenes = scene_topics.describe();
    ROS_WARN_STREAM("Waiting for usable clouds on " << object_topics.describe() << (scenes.empty() ? "" : ", ")
                                                    << scenes);
  }
  for (const std::string& line : rejections.take_report()) {
    ROS_WARN_STREAM(line);
  }
}

namespace {

// Turns package://NAME/PATH into the path of a file of the ROS package NAME. Every other text is a path already.
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

PredictionNode::PredictionNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                               const ModelLoader& make_predictor) {
  XmlRpc::XmlRpcValue tree;
  private_node.getParam("", tree);
  const NodeParameters parameters = read_parameters(tree);
  parts_ = std::make_unique<Parts>(node, private_node, parameters,
                                   [make_predictor, model = parameters.model] { return make_predictor(model); });
}

PredictionNode::~PredictionNode() = default;

void PredictionNode::stop() { parts_->forecaster.stop(); }

int run_prediction_node(const ModelLoader& make_predictor) {
  // These handles must outlive the try block: the end of the last handle shuts ROS down, and then the message of the
  // catch block would not be printed.
  const ros::NodeHandle public_handle, private_handle("~");
  try {
    ShutdownLimit limit;
    catch_interrupt();
    PredictionNode node(public_handle, private_handle, make_predictor);
    const int exit_code = wait_for_end();
    limit.start(exit_code);
    node.stop();
    ros::shutdown();  // This waits for callbacks in progress.
    return exit_code;
  } catch (const std::invalid_argument& error) {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
}

}  // namespace rigidformer_ros
