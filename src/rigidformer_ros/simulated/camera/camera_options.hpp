// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "rigidformer/io/members.hpp"
#include "rigidformer/simulation/depth_camera.hpp"

namespace rigidformer_ros::camera {

using rigidformer::Accepts;

/// What the simulated camera looks at and what it publishes. A member's name is the name of the ROS parameter and of
/// the command-line option, its initial value the only default.
struct CameraOptions {
  std::string scene_set = "movi_b";
  std::string scene_file;
  int seed = 1;
  int num_scenes = 1;
  double duration = 3.0;
  double pause = 1.5;
  double scale = 1.0;
  double frame_rate = 30.0;
  std::vector<double> position{7.5, -6.5, 5.3};
  std::vector<double> target{0.0, 0.0, 1.0};
  int width = rigidformer::CameraIntrinsics().width;
  int height = rigidformer::CameraIntrinsics().height;
  double horizontal_fov = rigidformer::CameraIntrinsics().horizontal_fov_rad;
  double max_range = rigidformer::DepthCameraOptions().max_range_m;
  double depth_noise = rigidformer::DepthCameraOptions().depth_noise_m;
  double pixel_noise = rigidformer::DepthCameraOptions().pixel_noise_px;
  double dropout = rigidformer::DepthCameraOptions().dropout;
  double mislabelled = rigidformer::DepthCameraOptions().mislabelled;
  std::string camera_frame = "camera_optical";
  std::string fixed_frame = "world";
  bool labels = true;
  bool object_clouds = false;
  bool object_frames = false;
  std::string pose_frame_prefix = "object_";

  /// Of the camera alone. The seed of the scenes is also that of the noise.
  rigidformer::DepthCameraOptions camera() const;

  /// Throws std::invalid_argument naming the option and what is accepted.
  void validate() const;
};

template <typename Visit>
void for_each_member(CameraOptions& o, const Visit& visit) {
  const Accepts any = rigidformer::anything();
  const Accepts positive = rigidformer::positive();
  const Accepts not_negative = rigidformer::at_least(0.0);
  visit("scene_set", o.scene_set, any, "movi_sphere, movi_a or movi_b, simulated now");
  visit("scene_file", o.scene_file, any, "Scene archive or folder to show instead; empty = simulate");
  visit("seed", o.seed, not_negative, "Of the scenes and of the noise");
  visit("num_scenes", o.num_scenes, not_negative, "Scenes one after another; 0 = until shutdown");
  visit("duration", o.duration, rigidformer::positive_up_to(60.0), "Simulated motion per scene, at scale 1 [s]");
  visit("pause", o.pause, not_negative, "Without any cloud between two scenes [s]");
  visit("scale", o.scale, positive, "Lengths times scale, times times its square root: 0.07 makes a tabletop scene");
  visit("frame_rate", o.frame_rate, positive, "Frames per second [Hz]");
  visit("position", o.position, any, "Of the camera in the fixed frame, at scale 1 [m]");
  visit("target", o.target, any, "What the camera looks at, at scale 1 [m]");
  visit("width", o.width, any, "Of the image [px]");
  visit("height", o.height, any, "Of the image [px]");
  visit("horizontal_fov", o.horizontal_fov, any, "Field of view [rad]");
  visit("max_range", o.max_range, any, "Farther surfaces give no point [m]");
  visit("depth_noise", o.depth_noise, any, "Standard deviation along the optical axis [m]");
  visit("pixel_noise", o.pixel_noise, any, "Standard deviation in the image [px]");
  visit("dropout", o.dropout, any, "Share of the pixels without a point");
  visit("mislabelled", o.mislabelled, any, "Share of the pixels at borders with the label from across the border");
  visit("camera_frame", o.camera_frame, any, "Optical frame of the clouds");
  visit("fixed_frame", o.fixed_frame, any, "Frame of the world, z up");
  visit("labels", o.labels, any, "Give every point the label of its object; otherwise x y z only, a bare depth camera");
  visit("object_clouds", o.object_clouds, any, "Also publish rigidformer_ros/ObjectClouds with the true poses");
  visit("object_frames", o.object_frames, any, "Also publish the true poses as tf frames");
  visit("pose_frame_prefix", o.pose_frame_prefix, any, "Names of these frames: the prefix, then the object's id");
}

}  // namespace rigidformer_ros::camera
