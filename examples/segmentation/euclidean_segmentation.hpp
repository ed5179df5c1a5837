// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/io/members.hpp"

/// What counts as the ground and as an object. The defaults suit objects of 5 to 10 cm seen from less than a metre.
struct SegmentationOptions {
  double max_range = 1.5;
  double plane_distance = 0.008;
  double min_plane_share = 0.2;
  double cluster_tolerance = 0.02;
  int min_cluster_points = 30;
};

// Shorter lengths than these are below what any depth camera resolves, and PCL's trees do not take 0.
template <typename Visit>
void for_each_member(SegmentationOptions& o, const Visit& visit) {
  using rigidformer::between;
  visit("max_range", o.max_range, between(0.0, 1000.0),
        "[m] largest distance from the camera (the cloud's origin); 0 = no limit");
  visit("plane_distance", o.plane_distance, between(1e-4, 1.0),
        "[m] largest distance of a ground point from the largest plane");
  visit("min_plane_share", o.min_plane_share, rigidformer::share(),
        "smallest share of the points on a plane that is the ground");
  visit("cluster_tolerance", o.cluster_tolerance, between(1e-3, 10.0),
        "[m] largest gap within an object, exact to about a quarter of it");
  visit("min_cluster_points", o.min_cluster_points, between(1.0, 1e6), "fewest points of an object");
}

/// The largest plane of a cloud [N, 3] m as (n, d) where n x + d = 0 and the unit normal n towards the camera, which is
/// the cloud's origin; empty where no plane holds the share of the points that a ground has.
std::optional<Eigen::Vector4d> find_ground(const rigidformer::Points& points, const SegmentationOptions& options);

/// Groups the finite points of a cloud [N, 3] m into objects on a plane. Each object is a list of row numbers. A row
/// that belongs to no object is in no list. The same cloud always gives the same objects, and a cloud with too few
/// points gives none.
std::vector<std::vector<int>> find_objects(const rigidformer::Points& points, const SegmentationOptions& options);
