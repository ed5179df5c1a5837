// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fixture_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "rigidformer/simulation/convex_hull.hpp"

namespace rigidformer {
namespace {

// Proportions, chosen by eye: second and third edge through the longest one, and diameters through heights.
constexpr double kSecondEdges[] = {1.0, 0.75, 0.5, 0.3, 0.16, 0.08};
constexpr double kThirdEdges[] = {1.0, 0.75, 0.5, 0.3, 0.16, 0.08, 0.04};
constexpr double kDiameters[] = {0.1, 0.2, 0.35, 0.6};
constexpr double kCell_m = 0.25;  // vertices of a box lie in a grid about that wide: they stand for its faces
constexpr int kPegSides = 16;

std::string name_of(const char* kind, const std::vector<double>& proportions) {
  std::string name = kind;
  for (const double value : proportions) name += "_" + std::to_string(std::lround(100.0 * value));
  return name;
}

/// A box with a grid of vertices on its faces, which face outwards.
ConvexPart grid_box(const Eigen::Vector3d& edges) {
  const Eigen::Vector3i cells = (edges / kCell_m).array().round().max(1.0).cast<int>();
  std::map<std::array<int, 3>, int> vertex_at;
  std::vector<Eigen::Vector3i> triangles;
  const auto vertex = [&](const Eigen::Vector3i& place) {
    return vertex_at.emplace(std::array{place.x(), place.y(), place.z()}, static_cast<int>(vertex_at.size()))
        .first->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + 1) % 3), v = Eigen::Vector3i::Unit((axis + 2) % 3);
    for (const int side : {0, cells[axis]}) {
      for (int i = 0; i < cells.dot(u); ++i) {
        for (int j = 0; j < cells.dot(v); ++j) {
          const Eigen::Vector3i place = side * Eigen::Vector3i::Unit(axis) + i * u + j * v;
          const int a = vertex(place), b = vertex(place + u), c = vertex(place + u + v), d = vertex(place + v);
          triangles.push_back(side > 0 ? Eigen::Vector3i(a, b, c) : Eigen::Vector3i(a, c, b));
          triangles.push_back(side > 0 ? Eigen::Vector3i(a, c, d) : Eigen::Vector3i(a, d, c));
        }
      }
    }
  }
  ConvexPart part;
  part.vertices.resize(static_cast<Eigen::Index>(vertex_at.size()), 3);
  for (const auto& [place, row] : vertex_at) {
    const Eigen::Array3d share = Eigen::Array3d(place[0], place[1], place[2]) / cells.cast<double>().array();
    part.vertices.row(row) = ((share - 0.5) * edges.array()).cast<float>().transpose();
  }
  part.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) part.triangles.row(static_cast<Eigen::Index>(i)) = triangles[i];
  return part;
}

ConvexPart peg(double diameter) {
  Points points(2 * kPegSides, 3);
  for (int i = 0; i < points.rows(); ++i) {
    const double angle_rad = 2.0 * M_PI * (i / 2) / kPegSides;
    points.row(i) << static_cast<float>(0.5 * diameter * std::cos(angle_rad)),
        static_cast<float>(0.5 * diameter * std::sin(angle_rad)), i % 2 == 0 ? -0.5F : 0.5F;
  }
  return convex_hull(points);
}

/// The value next to `wished`, as a factor.
template <typename Values>
double nearest(const Values& values, double wished) {
  return *std::min_element(std::begin(values), std::end(values), [&](double a, double b) {
    return std::abs(std::log(a / wished)) < std::abs(std::log(b / wished));
  });
}

}  // namespace

const std::vector<Shape>& fixture_shapes() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> all;
    for (const double second : kSecondEdges) {
      for (const double third : kThirdEdges) {
        if (third > second) continue;
        all.push_back({name_of("box", {1.0, second, third}), second * third, {grid_box({1.0, second, third})}});
      }
    }
    for (const double diameter : kDiameters) {
      all.push_back({name_of("peg", {diameter}), 0.25 * M_PI * diameter * diameter, {peg(diameter)}});
    }
    return all;
  }();
  return shapes;
}

Block block_of(const Eigen::Vector3d& wished_edges) {
  std::array<int, 3> axis{0, 1, 2};  // of the body, from the longest edge to the shortest
  std::stable_sort(axis.begin(), axis.end(), [&](int a, int b) { return wished_edges[a] > wished_edges[b]; });
  const double size = wished_edges[axis[0]];
  const double second = nearest(kSecondEdges, wished_edges[axis[1]] / size);
  const double third = std::min(second, nearest(kThirdEdges, wished_edges[axis[2]] / size));
  Block block{name_of("box", {1.0, second, third}), size, {}, {}};
  Eigen::Matrix3d turn;
  turn.col(0) = Eigen::Vector3d::Unit(axis[0]);
  turn.col(1) = Eigen::Vector3d::Unit(axis[1]);
  turn.col(2) = turn.col(0).cross(turn.col(1));
  block.rotation = Eigen::Quaterniond(turn);
  block.edges[axis[0]] = size;
  block.edges[axis[1]] = size * second;
  block.edges[axis[2]] = size * third;
  return block;
}

Block peg_of(double wished_diameter, double height) {
  const double diameter = nearest(kDiameters, wished_diameter / height);
  return {name_of("peg", {diameter}), height, Eigen::Quaterniond::Identity(),
          height * Eigen::Vector3d(diameter, diameter, 1.0)};
}

}  // namespace rigidformer
