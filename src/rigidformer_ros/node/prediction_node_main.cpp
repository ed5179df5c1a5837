// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/init.h>

#include <cstdio>
#include <cstdlib>

#include "rigidformer/model/threads.hpp"
#include "rigidformer_ros/node/prediction_node.hpp"

int main(int argc, char** argv) {
  rigidformer::use_vector_units();
  ros::init(argc, argv, "prediction_node");
  const int exit_code = rigidformer_ros::run_prediction_node();
  // Everything is tidied up by now. A normal return would spend half a second on destroying LibTorch's static objects.
  std::fflush(nullptr);
  std::_Exit(exit_code);
}
