// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation_parameters.hpp"

#include "rigidformer_ros/parameters/parameter_reader.hpp"

SegmentationParameters read_segmentation_parameters(const XmlRpc::XmlRpcValue& tree) {
  SegmentationParameters parameters;
  SegmentationOptions& options = parameters.options;
  rigidformer_ros::ParameterReader reader(tree, "");
  // Shorter lengths than these are below what any depth camera resolves, and PCL's trees do not take 0.
  reader.read("max_range", options.max_range, {0.0, 1000.0});
  reader.read("plane_distance", options.plane_distance, {1e-4, 1.0});
  reader.read("min_plane_share", options.min_plane_share, {0.0, 1.0});
  reader.read("cluster_tolerance", options.cluster_tolerance, {1e-3, 10.0});
  reader.read("min_cluster_points", options.min_cluster_points, {1.0, 1e6});
  reader.read("max_match_distance", parameters.max_match_distance, {1e-3, 100.0});
  reader.read("max_missed_frames", parameters.max_missed_frames, {0.0, 1e6});
  reader.finish();
  return parameters;
}
