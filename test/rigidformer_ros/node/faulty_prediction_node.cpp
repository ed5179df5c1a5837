// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/init.h>

#include "rigidformer_ros/faulty_predictor.hpp"
#include "rigidformer_ros/node/prediction_node.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "prediction_node");
  return rigidformer_ros::run_prediction_node(
      [](const rigidformer::PredictorOptions&) { return std::make_unique<rigidformer::FaultyPredictor>(); });
}
