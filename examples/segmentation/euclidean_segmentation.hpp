// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

/// What counts as the ground and as an object. The defaults suit objects of 5 to 10 cm seen from less than a metre.
struct SegmentationOptions {
  double max_range = 1.5;           ///< [m] Largest distance from the camera (the cloud's origin); 0 = no limit
  double plane_distance = 0.008;    ///< [m] Largest distance of a ground point from the largest plane
  double min_plane_share = 0.2;     ///< Smallest share of the points on a plane that is the ground
  double cluster_tolerance = 0.02;  ///< [m] Largest gap within an object, exact to about a quarter of it
  int min_cluster_points = 30;      ///< Fewest points of an object
};

/// Groups the finite points of a cloud [N, 3] m into objects on a plane. Each object is a list of row numbers. A row
/// that belongs to no object is in no list. The same cloud always gives the same objects, and a cloud with too few
/// points gives none.
std::vector<std::vector<int>> find_objects(const rigidformer::Points& points, const SegmentationOptions& options);
