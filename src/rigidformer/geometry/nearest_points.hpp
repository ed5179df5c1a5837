// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer {

/// For each of the N points of one object, the nearest point of any other object; -1 where there is no other object.
struct NearestNeighbors {
  std::vector<int> object;  ///< [N] number of the other object
  std::vector<int> point;   ///< [N] row in that object's cloud
};

/// A rigid cloud with its search tree. It is only read, so that searches in several threads may share it.
class SearchableCloud;

/// `cloud` [N, 3] m. Throws std::invalid_argument for an empty or non-finite cloud.
std::shared_ptr<const SearchableCloud> make_searchable(Points cloud);

/// Exact nearest points between rigid clouds that move. Each cloud gets one search tree in its own frame, built once; a
/// query only moves the poses. The answers of the last query bound the next search, so that small motions cost least.
/// Not thread safe; queries do not allocate after the first.
class NearestPoints {
 public:
  /// `clouds[i]` [N_i, 3] m in the frame of object i. Throws std::invalid_argument for an empty or non-finite cloud.
  explicit NearestPoints(std::vector<Points> clouds);
  static NearestPoints sharing(std::vector<std::shared_ptr<const SearchableCloud>> clouds);
  ~NearestPoints();
  NearestPoints(NearestPoints&&) noexcept;
  NearestPoints& operator=(NearestPoints&&) noexcept;

  /// Fills `nearest[i]` for every object i at the given poses, one per cloud. Distances are compared in float32. Throws
  /// std::invalid_argument for a wrong number of poses or an invalid pose.
  void query(const std::vector<RigidTransform>& T_world_object, std::vector<NearestNeighbors>& nearest);

 private:
  class Impl;
  explicit NearestPoints(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rigidformer
