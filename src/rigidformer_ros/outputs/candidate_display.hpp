// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rigidformer_ros/BatchRequest.h>
#include <rigidformer_ros/BatchResult.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <visualization_msgs/MarkerArray.h>

#include "rigidformer_ros/parameters/parameters.hpp"

namespace rigidformer_ros {

/// The candidates of a request for rviz: a path per object where poses were recorded, else a dot at its end; green =
/// done, orange = ended by a condition, red = failed, grey = not finished. Tracks of driven bodies are blue lines; they
/// are drawn where the request is stated in the fixed frame. At most the first 32 candidates are shown.
visualization_msgs::MarkerArray candidate_markers(const BatchRequest& request, const BatchResult& result,
                                                  const DisplayParameters& display);

/// Publishes them on `candidate_markers`; makes nothing when nobody looks.
class CandidateDisplay {
 public:
  CandidateDisplay(ros::NodeHandle& node, const DisplayParameters& display);

  void show(const BatchRequest& request, const BatchResult& result);

 private:
  DisplayParameters display_;
  ros::Publisher publisher_;
};

}  // namespace rigidformer_ros
