// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/playback/wait_for_node.hpp"

#include <rigidformer_ros/GetModelInfo.h>

namespace rigidformer_ros::demo {

void wait_for_node(ros::NodeHandle& node, SceneClock& clock) {
  auto client = node.serviceClient<GetModelInfo>("get_model_info");
  GetModelInfo info;
  while (ros::ok() && !(client.exists() && client.call(info) && info.response.ready)) {
    ROS_INFO_THROTTLE(10.0, "waiting for the prediction node: %s", info.response.message.c_str());
    clock.sleep_until(clock.now() + ros::Duration(0.2));
  }
}

}  // namespace rigidformer_ros::demo
