// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/convex_hull.hpp"

#include <LinearMath/btConvexHullComputer.h>

#include <Eigen/Eigenvalues>
#include <stdexcept>
#include <string>

namespace rigidformer {
namespace {

constexpr float kMinThickness_m = 0.01F;  // [m] thinner clouds get this thickness; chosen by eye

using Triangles = decltype(ConvexPart::triangles);

/// Cuts Bullet's faces, which are planar polygons, into fans of triangles that face away from `centre`.
Triangles fan_triangles(const btConvexHullComputer& hull, const Points& vertices) {
  const Eigen::Vector3f centre = vertices.colwise().mean().transpose();
  std::vector<Eigen::Vector3i> triangles;
  for (int face = 0; face < hull.faces.size(); ++face) {
    const btConvexHullComputer::Edge* first = &hull.edges[hull.faces[face]];
    const int apex = first->getSourceVertex();
    for (const auto* edge = first->getNextEdgeOfFace(); edge->getTargetVertex() != apex;
         edge = edge->getNextEdgeOfFace()) {
      Eigen::Vector3i triangle(apex, edge->getSourceVertex(), edge->getTargetVertex());
      const Eigen::Vector3f a = vertices.row(triangle[0]);
      const Eigen::Vector3f b = vertices.row(triangle[1]);
      const Eigen::Vector3f c = vertices.row(triangle[2]);
      if ((b - a).cross(c - a).dot(a - centre) < 0.0F) std::swap(triangle[1], triangle[2]);
      triangles.push_back(triangle);
    }
  }
  Triangles result(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    result.row(static_cast<Eigen::Index>(i)) = triangles[i].transpose();
  }
  return result;
}

}  // namespace

ConvexPart convex_hull(const Points& points) {
  btConvexHullComputer hull;
  if (points.rows() >= 4) hull.compute(points.data(), 3 * sizeof(float), static_cast<int>(points.rows()), 0, 0);
  if (hull.vertices.size() < 4 || hull.faces.size() < 4) {
    throw std::invalid_argument("convex_hull: " + std::to_string(points.rows()) + " points span no volume");
  }
  ConvexPart part;
  part.vertices.resize(hull.vertices.size(), 3);
  for (int i = 0; i < hull.vertices.size(); ++i) {
    part.vertices.row(i) << static_cast<float>(hull.vertices[i].x()), static_cast<float>(hull.vertices[i].y()),
        static_cast<float>(hull.vertices[i].z());
  }
  part.triangles = fan_triangles(hull, part.vertices);
  return part;
}

Points with_thickness(Points points) {
  const Eigen::RowVector3f mean = points.colwise().mean();
  const Eigen::Matrix3f scatter = (points.rowwise() - mean).transpose() * (points.rowwise() - mean);
  const Eigen::Matrix3f axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(scatter).eigenvectors();
  for (int k = 0; k < 3; ++k) {
    const Eigen::VectorXf along = points * axes.col(k);
    if (along.maxCoeff() - along.minCoeff() >= kMinThickness_m) continue;
    const Eigen::RowVector3f half = 0.5F * kMinThickness_m * axes.col(k).transpose();
    Points both(2 * points.rows(), 3);
    both << points.rowwise() + half, points.rowwise() - half;
    points = both;
  }
  return points;
}

}  // namespace rigidformer
