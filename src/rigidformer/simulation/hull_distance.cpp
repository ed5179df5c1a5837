// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "hull_distance.hpp"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet_conversion.hpp"

namespace rigidformer {
namespace {

constexpr double kSamePlane = 1.0 - 1e-9;  // cosine between the normals of triangles that are one face
constexpr double kSameDepth_m = 1e-3;      // corners within this of the deepest one share the contact; chosen by eye

/// How a hull reaches into the other one through one of the other's faces.
struct Overlap {
  Eigen::Vector3d deepest, normal;  ///< In the frame of the hull with the face [m]; the normal is the face's
  double gap_m = -std::numeric_limits<double>::infinity();  ///< Negative; of the face where it is largest
};

Overlap least_overlap(const SolidHull& faces, const SolidHull& corners, const RigidTransform& T_faces_corners) {
  const Eigen::Matrix3Xd reaching =
      (T_faces_corners.rotation.toRotationMatrix() * corners.vertices()).colwise() + T_faces_corners.translation;
  const Eigen::VectorXd gaps = (faces.normals().transpose() * reaching).rowwise().minCoeff() - faces.offsets();
  Eigen::Index face = 0;
  Overlap overlap;
  overlap.gap_m = gaps.maxCoeff(&face);
  overlap.normal = faces.normals().col(face);
  const Eigen::VectorXd heights = reaching.transpose() * overlap.normal;
  const double lowest = heights.minCoeff();
  int count = 0;
  overlap.deepest.setZero();
  for (Eigen::Index i = 0; i < heights.size(); ++i) {
    if (heights[i] > lowest + kSameDepth_m) continue;
    overlap.deepest += reaching.col(i);
    ++count;
  }
  overlap.deepest /= count;
  return overlap;
}

std::optional<ClosestPoints> overlapping_points(const SolidHull& a, const RigidTransform& T_world_a, const SolidHull& b,
                                                const RigidTransform& T_world_b) {
  if (a.offsets().size() == 0 || b.offsets().size() == 0) return std::nullopt;
  const RigidTransform T_a_b = T_world_a.inverse() * T_world_b;
  const Overlap into_b = least_overlap(b, a, T_a_b.inverse()), into_a = least_overlap(a, b, T_a_b);
  ClosestPoints closest;
  closest.gap_m = std::max(into_a.gap_m, into_b.gap_m);
  if (into_b.gap_m >= into_a.gap_m) {
    closest.normal = T_world_b.rotation * into_b.normal;
    closest.on_a = T_world_b * into_b.deepest;
    closest.on_b = closest.on_a - closest.gap_m * closest.normal;
  } else {
    closest.normal = -(T_world_a.rotation * into_a.normal);
    closest.on_b = T_world_a * into_a.deepest;
    closest.on_a = closest.on_b + closest.gap_m * closest.normal;
  }
  return closest;
}

}  // namespace

SolidHull::SolidHull(const ConvexPart& hull)
    : vertices_(hull.vertices.transpose().cast<double>()),
      normals_(3, hull.triangles.rows()),
      offsets_(hull.triangles.rows()),
      shape_(std::make_unique<btConvexHullShape>()) {
  Eigen::Index faces = 0;
  for (Eigen::Index i = 0; i < hull.triangles.rows(); ++i) {
    const auto corner = [&](int k) { return vertices_.col(hull.triangles(i, k)); };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    const bool is_new = faces == 0 || normal.dot(normals_.col(faces - 1)) < kSamePlane;
    if (!normal.allFinite() || normal.isZero() || !is_new) continue;
    normals_.col(faces) = normal;
    offsets_[faces++] = normal.dot(corner(0));
  }
  normals_.conservativeResize(3, faces);
  offsets_.conservativeResize(faces);
  for (Eigen::Index i = 0; i < vertices_.cols(); ++i) shape_->addPoint(to_bullet(vertices_.col(i)), false);
  shape_->recalcLocalAabb();
  shape_->setMargin(0);
}
SolidHull::~SolidHull() = default;
SolidHull::SolidHull(SolidHull&&) noexcept = default;

std::optional<ClosestPoints> closest_points(const SolidHull& a, const RigidTransform& T_world_a, const SolidHull& b,
                                            const RigidTransform& T_world_b) {
  btVoronoiSimplexSolver simplex;
  btGjkPairDetector detector(&a.shape(), &b.shape(), &simplex, nullptr);
  btGjkPairDetector::ClosestPointInput input;
  // Bullet computes in single precision: distances are measured near the origin, wherever the bodies are.
  const Eigen::Vector3d origin = T_world_a.translation;
  input.m_transformA = to_bullet(RigidTransform{T_world_a.rotation, Eigen::Vector3d::Zero()});
  input.m_transformB = to_bullet(RigidTransform{T_world_b.rotation, T_world_b.translation - origin});
  btPointCollector result;
  detector.getClosestPoints(input, result, nullptr);
  if (!result.m_hasResult || result.m_distance <= 0) return overlapping_points(a, T_world_a, b, T_world_b);
  ClosestPoints closest;
  closest.gap_m = result.m_distance;
  closest.normal = from_bullet(result.m_normalOnBInWorld);
  closest.on_b = origin + from_bullet(result.m_pointInWorld);
  closest.on_a = closest.on_b + closest.gap_m * closest.normal;
  const bool is_usable = closest.on_b.allFinite() && std::abs(closest.normal.norm() - 1.0) < 1e-3;
  return is_usable ? std::optional<ClosestPoints>(closest) : std::nullopt;
}

}  // namespace rigidformer
