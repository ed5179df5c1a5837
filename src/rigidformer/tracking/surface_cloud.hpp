// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/tracking/point_tree.hpp"

namespace rigidformer {

/// Points of a surface with their normals.
struct SurfaceCloud {
  Points points;   ///< [N, 3] m
  Points normals;  ///< [N, 3] unit, sign arbitrary; zero = none
};

/// Takes `count` evenly spaced rows, or all where there are fewer. Sensors deliver points by pixel, so that neighbours
/// in the cloud are neighbours in the image, and even counting thins evenly.
Points thin(const Points& points, Eigen::Index count);
SurfaceCloud thin(const SurfaceCloud& cloud, Eigen::Index count);

/// Moves the cloud: returns `T_b_a * cloud_a`.
SurfaceCloud transform(const RigidTransform& T_b_a, const SurfaceCloud& cloud_a);

/// Whether two unit normals of arbitrary sign can be those of one face. A zero normal fits only another zero normal.
bool on_same_face(const Eigen::Vector3f& normal_a, const Eigen::Vector3f& normal_b);

/// Estimates normals from each point's neighbours in `points` [N, 3] m, N >= 1. A point has none where
/// its neighbours do not lie on a plane. A point near an edge gets the normal of the face that it lies
/// on, as closely as `noise_m` allows.
SurfaceCloud estimate_surface(const Points& points, double noise_m);

/// Outward unit vector along the surface where a face ends, at row `row` of the points in `tree` [N, 3] m
/// with `normals` [N, 3]; zero elsewhere. A surface that bends away out of view, by its normals and the
/// object's `size_m`, does not end.
Eigen::Vector3f find_border(const PointTree& tree, const Points& normals, Eigen::Index row, double size_m);

}  // namespace rigidformer
