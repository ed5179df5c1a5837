// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <exception>

#include "rigidformer_ros/simulated/demo/demo_publisher.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "demo_publisher");
  ros::NodeHandle node;
  try {
    const auto parameters = rigidformer_ros::demo::DemoParameters::read(ros::NodeHandle("~"));
    rigidformer_ros::demo::DemoPublisher(node, parameters).run();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
