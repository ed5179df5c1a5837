// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include "euclidean_segmentation.hpp"

/// The private parameters of `segment_cloud`.
struct SegmentationParameters {
  SegmentationOptions options;
  double max_match_distance = 0.1;  ///< [m] an object farther from all that were seen is new
  int max_missed_frames = 5;        ///< An object unseen for longer is forgotten
};

/// Reads the tree of all private parameters; what is absent keeps its default. Throws std::invalid_argument naming the
/// parameter, its value and what is accepted, also for a name that nobody knows.
SegmentationParameters read_segmentation_parameters(const XmlRpc::XmlRpcValue& tree);
