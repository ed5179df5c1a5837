// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

/// Gives the objects of every frame the labels that they had before: an object is the
/// nearest one of the frames before it.
class StableLabels {
 public:
  /// An object farther than `max_distance_m` from all that were seen is new. One that was not seen for more than
  /// `max_missed` frames is forgotten.
  StableLabels(double max_distance_m, int max_missed) : max_distance_m_(max_distance_m), max_missed_(max_missed) {}

  /// Gives labels from 1 on, one per centroid [m] of this frame, all different. A label is never
  /// used twice for different objects.
  std::vector<std::uint32_t> assign(const std::vector<Eigen::Vector3d>& centroids);

 private:
  struct Known {
    Eigen::Vector3d centroid;
    int missed = 0;  ///< Number of frames since the object was seen
  };

  double max_distance_m_;
  int max_missed_;
  std::uint32_t next_label_ = 1;
  std::map<std::uint32_t, Known> known_;
};
