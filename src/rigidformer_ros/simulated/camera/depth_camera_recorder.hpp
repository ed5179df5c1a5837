// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "rigidformer_ros/simulated/camera/camera_options.hpp"

namespace rigidformer_ros::camera {

/// What went into a bag.
struct RecordingSummary {
  int num_scenes = 0;
  int num_frames = 0;
};

/// Writes what a DepthCameraPublisher with these options would publish into a bag: the camera's frame once, latched, on
/// /tf_static, then frame by frame with the stamps as times, from 1000 s on. Needs no ROS master. Throws
/// std::invalid_argument for unusable options, std::runtime_error naming the file when it cannot be written; half a bag
/// is not left.
RecordingSummary record_bag(const std::string& file, const CameraOptions& options);

}  // namespace rigidformer_ros::camera
