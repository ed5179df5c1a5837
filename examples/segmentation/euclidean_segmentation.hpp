// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

/// What counts as the ground and as an object. The defaults suit objects of 5 to 10 cm seen from less than a
/// metre; they were chosen by eye.
struct SegmentationOptions {
  double max_range = 1.5;         ///< [m] points farther from the camera (the cloud's origin) are left out; 0 = none is
  double plane_distance = 0.008;  ///< [m] points this near to the largest plane are ground
  double min_plane_share = 0.2;   ///< Share of the points that a plane must have to be the ground
  double cluster_tolerance = 0.02;  ///< [m] points nearer than this belong together, to about a quarter of it
  int min_cluster_points = 30;
};

/// Groups the finite points of a cloud [N, 3] m into objects on a plane. Each object is a list of row numbers; rows
/// that belong to no object are in no list. The same cloud gives the same objects; few or no points give none.
std::vector<std::vector<int>> find_objects(const rigidformer::Points& points, const SegmentationOptions& options);
