// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/scene/surface_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "rigidformer/geometry/random.hpp"

namespace rigidformer {
namespace {

constexpr float kInsideTolerance = 1e-4F;  // [m] within it a point lies on a face, not inside; chosen by eye
constexpr double kMinArea = 1e-12;         // [m^2] slivers below it have no reliable normal; chosen by eye
constexpr int kTriesPerPoint = 1000;       // rejected points after which a shape has no outer surface; chosen by eye

struct Triangle {
  Eigen::Vector3f corner, edge_1, edge_2, normal;
  std::size_t part;
};

/// The planes of one convex part: a point p lies inside when normals * p < offsets in every row.
struct Planes {
  Points normals;
  Eigen::VectorXf offsets;

  bool strictly_inside(const Eigen::Vector3f& p) const {
    return normals.rows() > 0 && ((normals * p - offsets).array() < -kInsideTolerance).all();
  }
};

/// The triangles of all parts with their running area, and the planes of each part.
struct Surface {
  std::vector<Triangle> triangles;
  std::vector<double> cumulative_area;
  std::vector<Planes> planes;
};

void add_part(const ConvexPart& part, std::size_t index, Surface& surface) {
  const std::size_t first = surface.triangles.size();
  double area = surface.cumulative_area.empty() ? 0.0 : surface.cumulative_area.back();
  for (Eigen::Index f = 0; f < part.triangles.rows(); ++f) {
    const Eigen::Vector3f a = part.vertices.row(part.triangles(f, 0));
    const Eigen::Vector3f edge_1 = part.vertices.row(part.triangles(f, 1)).transpose() - a;
    const Eigen::Vector3f edge_2 = part.vertices.row(part.triangles(f, 2)).transpose() - a;
    const Eigen::Vector3d cross = edge_1.cast<double>().cross(edge_2.cast<double>());
    if (cross.norm() < 2.0 * kMinArea) continue;
    area += 0.5 * cross.norm();
    surface.triangles.push_back({a, edge_1, edge_2, cross.normalized().cast<float>(), index});
    surface.cumulative_area.push_back(area);
  }
  Planes planes{Points(static_cast<Eigen::Index>(surface.triangles.size() - first), 3),
                Eigen::VectorXf(static_cast<Eigen::Index>(surface.triangles.size() - first))};
  for (std::size_t i = first; i < surface.triangles.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i - first);
    planes.normals.row(row) = surface.triangles[i].normal.transpose();
    planes.offsets[row] = surface.triangles[i].normal.dot(surface.triangles[i].corner);
  }
  surface.planes.push_back(std::move(planes));
}

Surface build_surface(const Shape& shape) {
  Surface surface;
  for (std::size_t i = 0; i < shape.parts.size(); ++i) add_part(shape.parts[i], i, surface);
  if (surface.triangles.empty()) throw std::invalid_argument("shape '" + shape.name + "' has no surface area");
  return surface;
}

const Triangle& draw_triangle(const Surface& surface, Random& random) {
  const double target = random.uniform(0.0, surface.cumulative_area.back());
  const auto found = std::upper_bound(surface.cumulative_area.begin(), surface.cumulative_area.end(), target);
  const auto index = std::min<std::ptrdiff_t>(found - surface.cumulative_area.begin(),
                                              static_cast<std::ptrdiff_t>(surface.triangles.size()) - 1);
  return surface.triangles[static_cast<std::size_t>(index)];
}

/// Draws a point uniformly from the triangle: the far half of the parallelogram is folded back.
Eigen::Vector3f draw_point(const Triangle& triangle, Random& random) {
  auto u = static_cast<float>(random.uniform(0.0, 1.0));
  auto v = static_cast<float>(random.uniform(0.0, 1.0));
  if (u + v > 1.0F) {
    u = 1.0F - u;
    v = 1.0F - v;
  }
  return triangle.corner + u * triangle.edge_1 + v * triangle.edge_2;
}

/// Whether the point lies inside another part or on a face that two parts share: looking outwards by more than
/// twice the tolerance finds both.
bool is_hidden(const Surface& surface, const Triangle& triangle, const Eigen::Vector3f& point) {
  const Eigen::Vector3f outside = point + 2.5F * kInsideTolerance * triangle.normal;
  for (std::size_t i = 0; i < surface.planes.size(); ++i) {
    if (i == triangle.part) continue;
    if (surface.planes[i].strictly_inside(point) || surface.planes[i].strictly_inside(outside)) return true;
  }
  return false;
}

}  // namespace

SurfaceSamples sample_surface(const Shape& shape, int count, std::uint64_t seed) {
  if (count < 0) throw std::invalid_argument("count = " + std::to_string(count) + " must be >= 0");
  const Surface surface = build_surface(shape);
  Random random(seed);
  SurfaceSamples samples{Points(count, 3), Points(count, 3)};
  std::int64_t tries = static_cast<std::int64_t>(kTriesPerPoint) * (count + 1);
  for (int i = 0; i < count;) {
    if (tries-- == 0) throw std::invalid_argument("shape '" + shape.name + "' has no outer surface");
    const Triangle& triangle = draw_triangle(surface, random);
    const Eigen::Vector3f point = draw_point(triangle, random);
    if (is_hidden(surface, triangle, point)) continue;
    samples.points.row(i) = point.transpose();
    samples.normals.row(i) = triangle.normal.transpose();
    ++i;
  }
  return samples;
}

SurfaceSamples vertices_with_normals(const Shape& shape) {
  const Points points = shape.vertices();
  Points normals = Points::Zero(points.rows(), 3);
  Eigen::Index first = 0;
  for (const ConvexPart& part : shape.parts) {
    for (Eigen::Index f = 0; f < part.triangles.rows(); ++f) {
      const Eigen::RowVector3i corner = part.triangles.row(f);
      const Eigen::RowVector3f edge_a = part.vertices.row(corner[1]) - part.vertices.row(corner[0]);
      const Eigen::RowVector3f edge_b = part.vertices.row(corner[2]) - part.vertices.row(corner[0]);
      for (int k = 0; k < 3; ++k) {
        normals.row(first + corner[k]) += edge_a.cross(edge_b);
      }
    }
    first += part.vertices.rows();
  }
  normals.rowwise().normalize();
  return {points, normals};
}

}  // namespace rigidformer
