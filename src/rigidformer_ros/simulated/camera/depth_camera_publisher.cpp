// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/camera/depth_camera_publisher.hpp"

#include "rigidformer_ros/simulated/playback/wait_for_node.hpp"

namespace rigidformer_ros::camera {

CameraOptions read_camera_options(demo::PrivateParameters& parameters) {
  CameraOptions options;
  for_each_member(options, [&](const std::string& name, auto& value, const Accepts&, const char*) {
    parameters.read(name, value);
  });
  options.validate();
  return options;
}

PlaybackOptions read_playback_options(demo::PrivateParameters& parameters) {
  PlaybackOptions playback;
  parameters.read("wait_for_node", playback.wait_for_node);
  parameters.read("publish_clock", playback.publish_clock);
  parameters.read("time_scale", playback.time_scale);
  return playback;
}

DepthCameraPublisher::DepthCameraPublisher(ros::NodeHandle& node, const CameraOptions& options,
                                           const PlaybackOptions& playback)
    : node_(node),
      options_(options),
      playback_(playback),
      clock_(node, playback.publish_clock, playback.time_scale),
      cloud_(node_.advertise<sensor_msgs::PointCloud2>(kCloudTopic, 2)),
      truth_(node_.advertise<SceneForecast>(kTruthTopic, 1, /*latch=*/true)) {
  if (options_.object_clouds) {
    object_clouds_ = node_.advertise<ObjectClouds>(kObjectCloudsTopic, 2);
  }
}

void DepthCameraPublisher::run() {
  const auto more = [this](int index) {
    return ros::ok() && (options_.num_scenes == 0 || index < options_.num_scenes);
  };
  for (int index = 0; more(index); ++index) {
    const CameraScene scene(options_, static_cast<std::uint64_t>(index));
    if (index == 0) {
      static_frames_.sendTransform(camera_transform(scene, options_, clock_.now()));
      if (playback_.wait_for_node) {
        demo::wait_for_node(node_, clock_);
      }
    }
    ROS_INFO("scene %d: %d objects", index, scene.num_objects());
    play(scene);
    clock_.sleep_until(clock_.now() + ros::Duration(options_.pause));
  }
}

void DepthCameraPublisher::play(const CameraScene& scene) {
  const ros::Time start = clock_.now();
  truth_.publish(make_truth(scene, options_, start));
  for (int frame = 0; ros::ok() && frame < scene.num_frames(); ++frame) {
    const ros::Time stamp = start + ros::Duration(scene.time_s(frame));
    if (!playback_.publish_clock && stamp + ros::Duration(1.0 / options_.frame_rate) < clock_.now()) {
      continue;  // The program is more than a frame late. It loses the frame, as a camera that cannot keep up would.
    }
    const FrameMessages messages = make_messages(scene, frame, options_, stamp);
    clock_.sleep_until(stamp);
    publish(messages);
  }
}

void DepthCameraPublisher::publish(const FrameMessages& messages) {
  if (options_.object_frames && !messages.object_frames.empty()) {
    frames_.sendTransform(messages.object_frames);
  }
  cloud_.publish(messages.cloud);
  if (options_.object_clouds) {
    object_clouds_.publish(messages.object_clouds);
  }
}

}  // namespace rigidformer_ros::camera
