// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <exception>

#include "rigidformer_ros/simulated/camera/depth_camera_publisher.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "depth_camera");
  ros::NodeHandle node;
  try {
    namespace camera = rigidformer_ros::camera;
    rigidformer_ros::demo::PrivateParameters parameters(ros::NodeHandle("~"));
    const camera::CameraOptions options = camera::read_camera_options(parameters);
    const camera::PlaybackOptions playback = camera::read_playback_options(parameters);
    parameters.finish();
    camera::DepthCameraPublisher(node, options, playback).run();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
