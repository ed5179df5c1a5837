// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/scene/shape.hpp"

class btConvexHullShape;

namespace rigidformer {

/// A convex hull, made ready for measuring distances.
class SolidHull {
 public:
  explicit SolidHull(const ConvexPart& hull);
  ~SolidHull();
  SolidHull(SolidHull&&) noexcept;
  const btConvexHullShape& shape() const { return *shape_; }
  const Eigen::Matrix3Xd& vertices() const { return vertices_; }
  const Eigen::Matrix3Xd& normals() const { return normals_; }
  const Eigen::VectorXd& offsets() const { return offsets_; }

 private:
  Eigen::Matrix3Xd vertices_;  ///< [3, V] m, in the body's frame
  Eigen::Matrix3Xd normals_;   ///< [3, F] unit, outwards
  Eigen::VectorXd offsets_;    ///< [F] m, distance of the face's plane from the origin
  std::unique_ptr<btConvexHullShape> shape_;
};

/// The points where two hulls come closest, or reach deepest into each other.
struct ClosestPoints {
  Eigen::Vector3d on_a, on_b;  ///< World [m]
  Eigen::Vector3d normal;      ///< Unit, from b to a
  double gap_m = 0.0;          ///< Negative = overlap
};

/// Measures with GJK. Where hulls overlap, the face with the least overlap decides; crossing edges are not looked at.
/// Empty where that fails (hulls without extent, poses far out).
std::optional<ClosestPoints> closest_points(const SolidHull& a, const RigidTransform& T_world_a, const SolidHull& b,
                                            const RigidTransform& T_world_b);

}  // namespace rigidformer
