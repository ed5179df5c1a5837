// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/enclosed_surface.hpp"

#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rigidformer {
namespace {

using Tetrahedron = std::array<int, 4>;
using Face = std::array<int, 3>;  // rows of the corners, in rising order

/// Width of a gap that lets air in, over the largest hole that random samples of a surface are
/// expected to leave. Chosen by eye.
constexpr double kGapInHoles = 1.5;
constexpr Eigen::Index kMinPoints = 20;  // points; fewer say nothing about dents; chosen by eye
constexpr double kMinSolidShare = 0.3;   // share of the hull's volume that must be solid; chosen by eye

/// Qhull's state, released also when an exception passes.
class Delaunay {
 public:
  explicit Delaunay(const Points& points) : coordinates_(points.cast<double>()) {
    qh_zero(&qhull_, nullptr);
    std::string command = "qhull d Qt Qbb Qz Pp";
    const int failed = qh_new_qhull(&qhull_, 3, static_cast<int>(coordinates_.rows()), coordinates_.data(), False,
                                    command.data(), nullptr, messages_.get());
    if (failed != 0) {
      release();
      throw std::invalid_argument("enclosed_surface: " + std::to_string(points.rows()) + " points span no volume");
    }
  }
  ~Delaunay() { release(); }
  Delaunay(const Delaunay&) = delete;
  Delaunay& operator=(const Delaunay&) = delete;

  std::vector<Tetrahedron> tetrahedra() {
    std::vector<Tetrahedron> all;
    qhT* qh = &qhull_;  // Qhull's loops want a variable of this name
    facetT* facet;
    FORALLfacets {
      if (facet->upperdelaunay) continue;
      Tetrahedron corners{};
      std::size_t count = 0;
      vertexT *vertex, **vertexp;
      FOREACHvertex_(facet->vertices) {
        if (count < 4) corners[count] = qh_pointid(qh, vertex->point);
        ++count;
      }
      if (count == 4 && *std::max_element(corners.begin(), corners.end()) < coordinates_.rows()) all.push_back(corners);
    }
    return all;
  }

 private:
  void release() {
    int left = 0, total = 0;
    qh_freeqhull(&qhull_, qh_ALL);
    qh_memfreeshort(&qhull_, &left, &total);
  }

  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> coordinates_;
  std::unique_ptr<FILE, int (*)(FILE*)> messages_{std::fopen("/dev/null", "w"), std::fclose};  // else they go to stderr
  qhT qhull_;
};

Eigen::Vector3d point(const Points& points, int row) { return points.row(row).transpose().cast<double>(); }

double volume(const Points& points, const Tetrahedron& t) {
  const Eigen::Vector3d a = point(points, t[0]);
  return std::abs((point(points, t[1]) - a).cross(point(points, t[2]) - a).dot(point(points, t[3]) - a)) / 6.0;
}

double circumradius(const Points& points, const Face& face) {
  const Eigen::Vector3d a = point(points, face[0]), b = point(points, face[1]), c = point(points, face[2]);
  const double double_area = (b - a).cross(c - a).norm();
  return (b - a).norm() * (c - b).norm() * (a - c).norm() / std::max(2.0 * double_area, 1e-18);
}

/// The largest empty circle among N random points on a surface is expected to be sqrt(log2 N) times as wide as the
/// median distance to the nearest neighbour: both follow from the chance exp(-pi density r^2) that a circle is empty.
double expected_hole(const Points& points) {
  std::vector<float> nearest;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Eigen::VectorXf squared = (points.rowwise() - points.row(i)).rowwise().squaredNorm();
    squared[i] = squared.maxCoeff();
    nearest.push_back(squared.minCoeff());
  }
  std::nth_element(nearest.begin(), nearest.begin() + nearest.size() / 2, nearest.end());
  return std::sqrt(nearest[nearest.size() / 2] * std::log2(static_cast<double>(points.rows())));
}

/// The face opposite to corner `k`.
Face face_of(const Tetrahedron& t, int k) {
  Face face{t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4]};
  std::sort(face.begin(), face.end());
  return face;
}

using Neighbours = std::map<Face, std::vector<std::size_t>>;

/// Marks every tetrahedron that air reaches from outside the hull through faces wider than `gap`.
std::vector<bool> find_air(const Points& points, const std::vector<Tetrahedron>& tetrahedra,
                           const Neighbours& neighbours, double gap) {
  std::vector<bool> air(tetrahedra.size(), false);
  std::vector<std::size_t> reached;
  const auto enter = [&](std::size_t i) {
    if (!air[i]) reached.push_back(i);
    air[i] = true;
  };
  for (const auto& [face, sides] : neighbours) {
    if (sides.size() == 1 && circumradius(points, face) > gap) enter(sides[0]);
  }
  while (!reached.empty()) {
    const Tetrahedron tetrahedron = tetrahedra[reached.back()];
    reached.pop_back();
    for (int k = 0; k < 4; ++k) {
      const Face face = face_of(tetrahedron, k);
      if (circumradius(points, face) <= gap) continue;
      for (const std::size_t side : neighbours.at(face)) enter(side);
    }
  }
  return air;
}

/// The face, turned so that it faces away from the fourth corner.
Eigen::RowVector3i outward(const Points& points, const Face& face, int fourth) {
  const Eigen::Vector3d a = point(points, face[0]);
  const Eigen::Vector3d normal = (point(points, face[1]) - a).cross(point(points, face[2]) - a);
  return normal.dot(point(points, fourth) - a) < 0.0 ? Eigen::RowVector3i(face[0], face[1], face[2])
                                                     : Eigen::RowVector3i(face[0], face[2], face[1]);
}

/// Keeps the points that are used and numbers them anew.
TriangleMesh compact(const Points& points, const std::vector<Eigen::RowVector3i>& triangles) {
  std::map<int, int> numbers;
  TriangleMesh mesh;
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      mesh.triangles(static_cast<Eigen::Index>(f), k) =
          numbers.emplace(triangles[f][k], static_cast<int>(numbers.size())).first->second;
    }
  }
  mesh.vertices.resize(static_cast<Eigen::Index>(numbers.size()), 3);
  for (const auto& [old_number, number] : numbers) mesh.vertices.row(number) = points.row(old_number);
  return mesh;
}

}  // namespace

std::optional<TriangleMesh> enclosed_surface(const Points& points) {
  if (points.rows() < kMinPoints) return std::nullopt;
  const std::vector<Tetrahedron> tetrahedra = Delaunay(points).tetrahedra();
  Neighbours neighbours;
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    for (int k = 0; k < 4; ++k) neighbours[face_of(tetrahedra[i], k)].push_back(i);
  }
  const std::vector<bool> air = find_air(points, tetrahedra, neighbours, kGapInHoles * expected_hole(points));
  double solid = 0.0, all = 0.0;
  std::vector<Eigen::RowVector3i> triangles;
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    const double size = volume(points, tetrahedra[i]);
    all += size;
    if (air[i]) continue;
    solid += size;
    for (int k = 0; k < 4; ++k) {
      const Face face = face_of(tetrahedra[i], k);
      const std::vector<std::size_t>& sides = neighbours.at(face);
      const bool outside = std::all_of(sides.begin(), sides.end(), [&](std::size_t s) { return s == i || air[s]; });
      if (outside) triangles.push_back(outward(points, face, tetrahedra[i][k]));
    }
  }
  if (solid < kMinSolidShare * all) return std::nullopt;
  return compact(points, triangles);
}

}  // namespace rigidformer
