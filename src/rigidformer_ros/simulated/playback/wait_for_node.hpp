// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include "rigidformer_ros/simulated/playback/scene_clock.hpp"

namespace rigidformer_ros::demo {

/// Returns when the prediction node says that its model is ready, or when ROS shuts down.
void wait_for_node(ros::NodeHandle& node, SceneClock& clock);

}  // namespace rigidformer_ros::demo
