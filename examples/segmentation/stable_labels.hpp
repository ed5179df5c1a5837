// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

/// Gives the objects of every frame the labels that they had in earlier frames. An object is taken for the nearest one
/// that was seen before.
class StableLabels {
 public:
  /// An object that is farther than `max_distance_m` from all known ones is new. An object that was not seen for more
  /// than `max_missed` frames is forgotten.
  StableLabels(double max_distance_m, int max_missed) : max_distance_m_(max_distance_m), max_missed_(max_missed) {}

  /// Gives a label to each centroid [m] of this frame. Labels count from 1, are different within a frame, and are never
  /// used again for another object.
  std::vector<std::uint32_t> assign(const std::vector<Eigen::Vector3d>& centroids);

 private:
  struct Known {
    Eigen::Vector3d centroid;
    int missed = 0;  ///< Frames since the object was last seen
  };

  double max_distance_m_;
  int max_missed_;
  std::uint32_t next_label_ = 1;
  std::map<std::uint32_t, Known> known_;
};
