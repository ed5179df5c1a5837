// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/camera/camera_options.hpp"

#include <stdexcept>

#include "rigidformer/io/member_table.hpp"

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
  CameraOptions copy = *this;
  for_each_member(copy, [](const std::string& name, const auto& value, const Accepts& accepts, const char*) {
    require(rigidformer::fits(value, accepts), name + ": is " + rigidformer::value_text(value, accepts) + ", must be " +
                                                   rigidformer::values_text(accepts));
  });
  require(position.size() == 3 && target.size() == 3, "position and target: must have three numbers each");
  require(position[0] != target[0] || position[1] != target[1],
          "position: is straight above target, where the direction of the image is not defined");
  require(!camera_frame.empty() && !fixed_frame.empty() && camera_frame != fixed_frame,
          "camera_frame and fixed_frame: must be two names");
}

}  // namespace rigidformer_ros::camera
