// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/convex_parts.hpp"

#include <HACD/hacdHACD.h>

#include <stdexcept>

#include "rigidformer/baselines/enclosed_surface.hpp"
#include "rigidformer/simulation/convex_hull.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {
namespace {

using Vertices = std::vector<HACD::Vec3<HACD::Real>>;
using Triangles = std::vector<HACD::Vec3<long>>;

// Settings of the decomposition, chosen by eye but for the connect distance.
constexpr double kConvexShare = 0.9;      // share of the hull's volume that is solid in a convex object
constexpr double kConcavity = 20.0;       // depth of a dent that may stay, in thousandths of the object's size
constexpr double kCompactness = 1e-4;     // weight of compact parts against shallow dents
constexpr double kConnectDistance = 0.0;  // [m] the surface is connected already
constexpr int kMaxVertices = 100;         // vertices of one part

HACD::Vec3<HACD::Real> to_hacd(const Eigen::RowVector3f& v) { return {v.x(), v.y(), v.z()}; }

/// Gives the vertices of one part. HACD wants room for the part's triangles too.
Points part_vertices(HACD::HACD& hacd, std::size_t part) {
  Vertices vertices(hacd.GetNPointsCH(part));
  Triangles triangles(hacd.GetNTrianglesCH(part));
  hacd.GetCH(part, vertices.data(), triangles.data());
  Points points(static_cast<Eigen::Index>(vertices.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto& v = vertices[static_cast<std::size_t>(i)];
    points.row(i) << static_cast<float>(v.X()), static_cast<float>(v.Y()), static_cast<float>(v.Z());
  }
  return points;
}

std::vector<ConvexPart> decompose(const TriangleMesh& mesh) {
  Vertices vertices;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) vertices.push_back(to_hacd(mesh.vertices.row(i)));
  Triangles triangles;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    triangles.emplace_back(mesh.triangles(f, 0), mesh.triangles(f, 1), mesh.triangles(f, 2));
  }
  HACD::HACD hacd;
  hacd.SetPoints(vertices.data());
  hacd.SetNPoints(vertices.size());
  hacd.SetTriangles(triangles.data());
  hacd.SetNTriangles(triangles.size());
  hacd.SetNClusters(1);  // parts at least
  hacd.SetConcavity(kConcavity);
  hacd.SetCompacityWeight(kCompactness);
  hacd.SetVolumeWeight(0.0);
  hacd.SetConnectDist(kConnectDistance);
  hacd.SetNVerticesPerCH(kMaxVertices);
  hacd.SetAddExtraDistPoints(false);
  hacd.SetAddNeighboursDistPoints(false);
  hacd.SetAddFacesPoints(false);
  hacd.Compute();
  std::vector<ConvexPart> parts;
  for (std::size_t part = 0; part < hacd.GetNClusters(); ++part) {
    try {
      parts.push_back(convex_hull(part_vertices(hacd, part)));
    } catch (const std::invalid_argument&) {
      continue;  // a flat part has no volume to add
    }
  }
  return parts;
}

}  // namespace

std::vector<ConvexPart> convex_parts(const Points& points) {
  const ConvexPart hull = convex_hull(points);
  const std::optional<TriangleMesh> surface = enclosed_surface(points);
  if (!surface || measure_volume(*surface).volume_m3 > kConvexShare * measure_volume(hull).volume_m3) return {hull};
  const std::vector<ConvexPart> parts = decompose(*surface);
  return parts.empty() ? std::vector<ConvexPart>{hull} : parts;
}

}  // namespace rigidformer
