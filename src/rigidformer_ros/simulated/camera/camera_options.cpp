// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/camera/camera_options.hpp"

#include <stdexcept>

namespace rigidformer_ros::camera {
namespace {

void require(bool accepted, const std::string& message) {
  if (!accepted) {
    throw std::invalid_argument(message);
  }
}

}  // namespace

rigidformer::DepthCameraOptions CameraOptions::camera() const {
  rigidformer::DepthCameraOptions options;
  options.intrinsics = {width, height, horizontal_fov};
  options.max_range_m = max_range;
  options.depth_noise_m = depth_noise;
  options.pixel_noise_px = pixel_noise;
  options.dropout = dropout;
  options.mislabelled = mislabelled;
  options.seed = static_cast<std::uint64_t>(seed);
  return options;
}

void CameraOptions::validate() const {
  camera().validate();
  require(seed >= 0, "seed: is " + std::to_string(seed) + ", must be at least 0");
  require(num_scenes >= 0, "num_scenes: is " + std::to_string(num_scenes) + ", must be at least 0");
  require(duration > 0.0 && duration <= 60.0, "duration: is " + std::to_string(duration) + ", must be in (0, 60] s");
  require(pause >= 0.0, "pause: is " + std::to_string(pause) + ", must be at least 0 s");
  require(scale > 0.0, "scale: is " + std::to_string(scale) + ", must be positive");
  require(frame_rate > 0.0, "frame_rate: is " + std::to_string(frame_rate) + ", must be positive");
  require(position.size() == 3 && target.size() == 3, "position and target: must have three numbers each");
  require(position[0] != target[0] || position[1] != target[1],
          "position: is straight above target, where the direction of the image is not defined");
  require(!camera_frame.empty() && !fixed_frame.empty() && camera_frame != fixed_frame,
          "camera_frame and fixed_frame: must be two names");
}

}  // namespace rigidformer_ros::camera
