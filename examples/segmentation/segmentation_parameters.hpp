// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include "euclidean_segmentation.hpp"

/// The private parameters of `segment_cloud`.
struct SegmentationParameters {
  SegmentationOptions options;
  double max_match_distance = 0.1;
  int max_missed_frames = 5;
};

/// The members of the options stand beside those of the struct, as the parameters do.
template <typename Visit>
void for_each_member(SegmentationParameters& o, const Visit& visit) {
  for_each_member(o.options, visit);
  visit("max_match_distance", o.max_match_distance, rigidformer::between(1e-3, 100.0),
        "[m] an object farther from all that were seen is new");
  visit("max_missed_frames", o.max_missed_frames, rigidformer::between(0.0, 1e6),
        "an object unseen for longer is forgotten");
}

/// Reads the tree of all private parameters; what is absent keeps its default. Throws std::invalid_argument naming the
/// parameter, its value and what is accepted, also for a name that nobody knows.
SegmentationParameters read_segmentation_parameters(const XmlRpc::XmlRpcValue& tree);
