// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "rigidformer_ros/prediction_node.hpp"

namespace rigidformer_ros {

/// The prediction node inside a nodelet manager, where clouds of other nodelets arrive without being copied.
class PredictionNodelet : public nodelet::Nodelet {
 private:
  // An exception here makes the manager refuse the nodelet and say why.
  void onInit() override { node_ = make_prediction_node(getNodeHandle(), getPrivateNodeHandle()); }

  std::unique_ptr<PredictionNode> node_;
};

}  // namespace rigidformer_ros

PLUGINLIB_EXPORT_CLASS(rigidformer_ros::PredictionNodelet, nodelet::Nodelet)
