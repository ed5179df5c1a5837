// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// Finds the nearest points of one cloud, for points of that cloud or any others.
class PointTree {
 public:
  /// Copies `points` [N, 3] m, N >= 1, finite, into a search tree.
  explicit PointTree(Points points);
  ~PointTree();
  PointTree(PointTree&&) noexcept;
  PointTree& operator=(PointTree&&) noexcept;

  const Points& points() const;

  /// Row of the nearest point.
  int nearest(const Eigen::Vector3f& point) const;

  /// Fills `rows` with the rows of the nearest points, nearest first, and returns how many there are (at most N).
  template <std::size_t Count>
  int nearest(const Eigen::Vector3f& point, std::array<int, Count>& rows) const {
    std::array<float, Count> squared_distances;
    return find(point, rows.data(), squared_distances.data(), static_cast<int>(Count));
  }

  /// Fills `rows` with the rows of the `count` (at most N) nearest points, nearest first.
  void nearest(const Eigen::Vector3f& point, int count, std::vector<int>& rows) const;

 private:
  class Index;
  int find(const Eigen::Vector3f& point, int* rows, float* squared_distances, int count) const;

  std::unique_ptr<Index> index_;
};

/// Distance [m] of each point from its third nearest neighbour, or from the farthest one where there are fewer.
std::vector<double> neighbor_spacing(const PointTree& tree);

}  // namespace rigidformer
