// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/demo/demo_publisher.hpp"

#include <geometry_msgs/TransformStamped.h>
#include <rigidformer_ros/SceneForecast.h>

#include <cmath>
#include <stdexcept>

#include "rigidformer/simulation/depth_camera.hpp"
#include "rigidformer/simulation/scene_set.hpp"
#include "rigidformer_ros/messages/conversions.hpp"
#include "rigidformer_ros/simulated/demo/demo_clouds.hpp"
#include "rigidformer_ros/simulated/playback/private_parameters.hpp"
#include "rigidformer_ros/simulated/playback/wait_for_node.hpp"

namespace rigidformer_ros::demo {
namespace {

// [Hz] frames that scenes with the default of BulletSettings record per second.
constexpr double kFrameRate = 240.0;

int frames_per_cloud(double cloud_rate) { return static_cast<int>(std::lround(kFrameRate / cloud_rate)); }

}  // namespace

DemoParameters DemoParameters::read(const ros::NodeHandle& private_node) {
  DemoParameters p;
  PrivateParameters parameters(private_node);
  parameters.read("scene_set", p.scene_set);
  parameters.read("seed", p.seed);
  parameters.read("num_scenes", p.num_scenes);
  parameters.read("scene_duration", p.scene_duration);
  parameters.read("pause", p.pause);
  parameters.read("cloud_rate", p.cloud_rate);
  parameters.read("points_per_object", p.points_per_object);
  parameters.read("camera_frame", p.camera_frame);
  parameters.read("fixed_frame", p.fixed_frame);
  parameters.read("wait_for_node", p.wait_for_node);
  parameters.read("publish_clock", p.publish_clock);
  parameters.read("time_scale", p.time_scale);
  parameters.read("hold_at", p.hold_at);
  parameters.finish();
  if (!(p.cloud_rate >= 1.0 && p.cloud_rate <= kFrameRate) ||
      std::abs(frames_per_cloud(p.cloud_rate) * p.cloud_rate - kFrameRate) > 1e-6) {
    throw std::invalid_argument("cloud_rate must be at least 1 Hz and divide 240 Hz, got " +
                                std::to_string(p.cloud_rate));
  }
  if (!(p.scene_duration > 0.0) || (p.points_per_object < 4 && p.points_per_object != 0)) {
    throw std::invalid_argument("scene_duration must be positive and points_per_object at least 4, or 0");
  }
  rigidformer::check_scene_set(p.scene_set);
  if (rigidformer::has_commands(p.scene_set)) {
    throw std::invalid_argument("scene_set '" + p.scene_set + "' follows commands, which topics do not carry");
  }
  if (p.hold_at >= 0.0 && !p.publish_clock) {
    throw std::invalid_argument("hold_at needs publish_clock: the system's time cannot be stopped");
  }
  return p;
}

DemoPublisher::DemoPublisher(ros::NodeHandle& node, const DemoParameters& parameters)
    : node_(node),
      parameters_(parameters),
      clock_(node, parameters.publish_clock, parameters.time_scale),
      T_camera_world_(rigidformer::look_at({7.5, -6.5, 5.3}, {0.0, 0.0, 1.0}).inverse()) {
  // So many topics are offered from the start.
  const int num_topics = rigidformer::max_num_objects(parameters.scene_set);
  for (int object = 0; object < num_topics; ++object) {
    const std::string topic = "/objects/" + DemoScene::object_id(object) + "/points";
    object_clouds_.push_back(node_.advertise<sensor_msgs::PointCloud2>(topic, 1));
  }
  labelled_cloud_ = node_.advertise<sensor_msgs::PointCloud2>("/cloud", 1);
  truth_ = node_.advertise<SceneForecast>("demo/truth", 1, /*latch=*/true);
}

void DemoPublisher::run() {
  publish_camera();
  if (parameters_.wait_for_node) {
    wait_for_node(node_, clock_);
  }
  DemoSceneOptions options;
  options.set = parameters_.scene_set;
  options.seed = parameters_.seed;
  options.num_frames = static_cast<int>(std::lround(parameters_.scene_duration * kFrameRate)) + 1;
  options.points_per_object = parameters_.points_per_object;
  for (; ros::ok() && (parameters_.num_scenes == 0 || static_cast<int>(options.index) < parameters_.num_scenes);
       ++options.index) {
    const DemoScene scene(options);
    ROS_INFO("scene %d: %d objects", static_cast<int>(options.index), scene.num_objects());
    play(scene, options.index == 0 && parameters_.hold_at >= 0.0);
    clock_.sleep_until(clock_.now() + ros::Duration(parameters_.pause));
  }
}

void DemoPublisher::publish_camera() {
  const rigidformer::RigidTransform T_world_camera = T_camera_world_.inverse();
  geometry_msgs::TransformStamped message;
  message.header.stamp = clock_.now();
  message.header.frame_id = parameters_.fixed_frame;
  message.child_frame_id = parameters_.camera_frame;
  const geometry_msgs::Pose pose = to_pose(T_world_camera);
  message.transform.translation.x = pose.position.x;
  message.transform.translation.y = pose.position.y;
  message.transform.translation.z = pose.position.z;
  message.transform.rotation = pose.orientation;
  tf_.sendTransform(message);
}

void DemoPublisher::play(const DemoScene& scene, bool hold) {
  const ros::Time start = clock_.now();
  publish_truth(scene, start);
  for (int frame = 0; ros::ok() && frame < scene.num_frames(); frame += frames_per_cloud(parameters_.cloud_rate)) {
    const double scene_time = frame / scene.frame_rate_hz();
    clock_.sleep_until(start + ros::Duration(scene_time));
    publish_clouds(scene, frame, start + ros::Duration(scene_time));
    if (hold && scene_time >= parameters_.hold_at) {
      ROS_INFO("holding the scene at %.3f s", scene_time);
      while (ros::ok()) {
        clock_.hold(1.0);
      }
    }
  }
}

void DemoPublisher::publish_truth(const DemoScene& scene, const ros::Time& start) {
  SceneForecast truth;
  truth.header.stamp = start;
  truth.header.frame_id = parameters_.fixed_frame;
  truth.time_step = 1.0 / scene.frame_rate_hz();
  truth.model_id = "simulation";
  for (int frame = 0; frame < scene.num_frames(); ++frame) {
    truth.times.push_back(frame / scene.frame_rate_hz());
  }
  for (int object = 0; object < scene.num_objects(); ++object) {
    ObjectForecast motion;
    motion.id = DemoScene::object_id(object);
    for (int frame = 0; frame < scene.num_frames(); ++frame) {
      motion.poses.push_back(to_pose(scene.T_world_cloud(object, frame)));
    }
    truth.objects.push_back(motion);
  }
  truth_.publish(truth);
}

void DemoPublisher::publish_clouds(const DemoScene& scene, int frame, const ros::Time& stamp) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = parameters_.camera_frame;
  std::vector<rigidformer::Points> objects;
  for (int object = 0; object < scene.num_objects(); ++object) {
    objects.push_back(T_camera_world_.apply(scene.cloud_world(object, frame)));
    object_clouds_.at(object).publish(make_object_cloud(objects.back(), header));
  }
  labelled_cloud_.publish(make_labelled_cloud(objects, header));
}

}  // namespace rigidformer_ros::demo
