// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/surface_normals.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace rigidformer {
namespace {

constexpr Eigen::Index kSupportPoints = 256;
constexpr std::size_t kNeighbours = 12;
constexpr double kThickness = 0.15;   // of a plane, in root mean square distances of the neighbours
constexpr double kSharpness = 2.0;    // by how much each neighbour off a plane speaks against it
constexpr double kWeightAbove = 4.0;  // of neighbours outside of a plane: most surfaces are convex
constexpr double kLeastSine = 0.3;    // between the two directions that span a plane
constexpr double kTrustedPlanarity = 0.25;

using Offsets = Eigen::MatrixX3d;

/// The rows of the nearest points beside the point itself, nearest first.
std::vector<Eigen::Index> nearest_rows(const Eigen::VectorXd& squared_distance) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < squared_distance.size(); ++row) {
    if (squared_distance[row] > 0.0) rows.push_back(row);
  }
  const auto count = static_cast<std::ptrdiff_t>(std::min(kNeighbours, rows.size()));
  std::partial_sort(rows.begin(), rows.begin() + count, rows.end(),
                    [&](Eigen::Index a, Eigen::Index b) { return squared_distance[a] < squared_distance[b]; });
  rows.resize(static_cast<std::size_t>(count));
  return rows;
}

/// Direction of the field that equal charges on the surface have at the point. It points out of convex bodies, also on
/// flat faces, where neighbours alone do not tell, and mostly into the hole of a ring, because near charges count most.
Eigen::Vector3d field_direction(const Offsets& offsets, const Eigen::VectorXd& squared_distance, double softening) {
  const Eigen::VectorXd weight = (squared_distance.array() + softening).pow(-1.5);
  return -(offsets.transpose() * weight).stableNormalized();
}

/// How badly the neighbours fit to a plane through the point with this outward normal.
double misfit(const Offsets& near, const Eigen::Vector3d& normal, double squared_thickness) {
  double sum = 0.0;
  for (Eigen::Index row = 0; row < near.rows(); ++row) {
    const double height = near.row(row).dot(normal);
    const double off = height * height / (height * height + squared_thickness);
    sum += height > 0.0 ? kWeightAbove * off : off;
  }
  return sum;
}

/// Mean of the normals of all planes through the point and two neighbours, weighted by how well they fit: on a face
/// near an edge this is the normal of the face, at a corner the mean of its faces.
Eigen::Vector3d fitted_normal(const Offsets& near, const Eigen::Vector3d& outwards) {
  const double squared_thickness = kThickness * kThickness * near.rowwise().squaredNorm().mean();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double best = 0.0;
  for (Eigen::Index a = 0; a < near.rows(); ++a) {
    for (Eigen::Index b = a + 1; b < near.rows(); ++b) {
      Eigen::Vector3d normal = near.row(a).cross(near.row(b));
      const double area = normal.norm();
      if (!(area > kLeastSine * near.row(a).norm() * near.row(b).norm())) continue;
      normal *= (normal.dot(outwards) < 0.0 ? -1.0 : 1.0) / area;
      const double fit = -kSharpness * misfit(near, normal, squared_thickness);
      if (sum.isZero() || fit > best) {
        sum *= sum.isZero() ? 0.0 : std::exp(best - fit);  // weights are relative to the best plane so far
        best = fit;
      }
      sum += std::exp(fit - best) * normal;
    }
  }
  return sum.stableNormalized();
}

/// Near 0 where neighbours lie on a line (the rim of a mesh of a cylinder) or all around, towards 1 on a surface.
double planarity(const Offsets& near) {
  Offsets points(near.rows() + 1, 3);
  points << near, Eigen::RowVector3d::Zero();
  const Offsets centred = points.rowwise() - points.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(centred.transpose() * centred, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& spread = axes.eigenvalues();
  return spread[2] > 0.0 ? (spread[1] - spread[0]) / spread[2] : 0.0;
}

Eigen::Vector3d normal_of(const Offsets& offsets) {
  const Eigen::VectorXd squared_distance = offsets.rowwise().squaredNorm();
  const std::vector<Eigen::Index> rows = nearest_rows(squared_distance);
  if (rows.empty()) return Eigen::Vector3d::UnitZ();
  const Offsets near = offsets(rows, Eigen::all);
  const Eigen::Vector3d outwards = field_direction(offsets, squared_distance, squared_distance(rows).mean());
  const double trust = std::clamp(planarity(near) / kTrustedPlanarity, 0.0, 1.0);
  const Eigen::Vector3d normal = trust * fitted_normal(near, outwards) + (1.0 - trust) * outwards;
  return normal.isZero() ? Eigen::Vector3d::UnitZ() : normal.normalized();
}

}  // namespace

Points estimate_normals(const Points& points) {
  const Eigen::MatrixX3d support = points.topRows(std::min(points.rows(), kSupportPoints)).cast<double>();
  Points normals(points.rows(), 3);
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    const Offsets offsets = support.rowwise() - points.row(row).cast<double>();
    normals.row(row) = normal_of(offsets).cast<float>().transpose();
  }
  return normals;
}

}  // namespace rigidformer
