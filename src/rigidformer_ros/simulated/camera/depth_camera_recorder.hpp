// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "rigidformer_ros/simulated/camera/camera_options.hpp"

namespace rigidformer_ros::camera {

/// How much went into a bag.
struct RecordingSummary {
  int num_scenes = 0;
  int num_frames = 0;
};

/// Writes into a bag what a DepthCameraPublisher with these options would publish. The pose of the camera is written
/// once, latched, on /tf_static; then the scenes come frame by frame. The time of a message is its stamp, and the first
/// stamp is 1000 s. No ROS master is needed. Throws std::invalid_argument for unusable options, and std::runtime_error
/// naming the file when it cannot be written; no half-written bag is left then.
RecordingSummary record_bag(const std::string& file, const CameraOptions& options);

}  // namespace rigidformer_ros::camera
