// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/nodelet.h>

#include <exception>
#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "rigidformer_ros/node/prediction_node.hpp"

namespace rigidformer_ros {

/// The prediction node inside a nodelet manager, where clouds of other nodelets arrive without being copied.
class PredictionNodelet : public nodelet::Nodelet {
 private:
  // An exception makes the manager refuse the nodelet, but the manager does not say why: the text is printed here.
  void onInit() override {
    try {
      node_ = std::make_unique<PredictionNode>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const std::exception& error) {
      NODELET_FATAL_STREAM(error.what());
      throw;
    }
  }

  std::unique_ptr<PredictionNode> node_;
};

}  // namespace rigidformer_ros

PLUGINLIB_EXPORT_CLASS(rigidformer_ros::PredictionNodelet, nodelet::Nodelet)
