// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation_parameters.hpp"

#include "rigidformer_ros/parameters/parameter_reader.hpp"

SegmentationParameters read_segmentation_parameters(const XmlRpc::XmlRpcValue& tree) {
  SegmentationParameters parameters;
  rigidformer_ros::ParameterReader(tree, "").read_group(parameters);
  return parameters;
}
