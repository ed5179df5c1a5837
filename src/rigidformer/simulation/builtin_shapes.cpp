// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/builtin_shapes.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "rigidformer/data/kubasic.hpp"
#include "rigidformer/simulation/convex_hull.hpp"

namespace rigidformer {
namespace {

using PointList = std::vector<Eigen::Vector3d>;

ConvexPart hull_of(const PointList& list) {
  Points points(static_cast<Eigen::Index>(list.size()), 3);
  for (std::size_t i = 0; i < list.size(); ++i) {
    points.row(static_cast<Eigen::Index>(i)) = list[i].cast<float>().transpose();
  }
  return convex_hull(points);
}

/// Appends `count` points of a circle spanned by the orthonormal axes `u` and `v`.
void add_circle(PointList& list, int count, double radius, const Eigen::Vector3d& centre, const Eigen::Vector3d& u,
                const Eigen::Vector3d& v) {
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count;
    list.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
}

/// Spreads points evenly over an ellipsoid along a golden spiral.
PointList ellipsoid(int count, const Eigen::Vector3d& centre, const Eigen::Vector3d& radii) {
  const double golden_angle = M_PI * (3.0 - std::sqrt(5.0));
  PointList list;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double r = std::sqrt(1.0 - z * z);
    list.push_back(centre + radii.cwiseProduct(
                                Eigen::Vector3d(r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z)));
  }
  return list;
}

ConvexPart box(const Eigen::Vector3d& centre, const Eigen::Vector3d& half_extents) {
  PointList list;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    list.push_back(centre + sign.cwiseProduct(half_extents));
  }
  return hull_of(list);
}

/// Makes a cube whose corners and edges are slightly cut, as those of real things are.
std::vector<ConvexPart> make_cube() {
  constexpr double kHalf = 0.5;    // [m] half the edge of a cube of 1 m
  constexpr double kBevel = 0.02;  // [m] cut from corners and edges; chosen by eye
  PointList list;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 8; ++corner) {
      Eigen::Vector3d point;
      for (int i = 0; i < 3; ++i) {
        point[i] = ((corner >> i & 1) != 0 ? 1 : -1) * (i == axis ? kHalf : kHalf - kBevel);
      }
      list.push_back(point);
    }
  }
  return {hull_of(list)};
}

/// Makes a solid of revolution about z through the (z, radius) profile, with one convex frustum per profile segment.
std::vector<ConvexPart> revolve(const std::vector<std::pair<double, double>>& profile, int sides) {
  std::vector<ConvexPart> parts;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    PointList list;
    for (const auto& [z, radius] : {profile[i], profile[i + 1]}) {
      const Eigen::Vector3d centre(0, 0, z);
      if (radius > 0.0) {
        add_circle(list, sides, radius, centre, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
      } else {
        list.push_back(centre);
      }
    }
    parts.push_back(hull_of(list));
  }
  return parts;
}

/// Makes a closed tube along `curve` (parameter 0...1), with one convex part per segment;
/// neighbours share their end circle.
std::vector<ConvexPart> tube(const std::function<Eigen::Vector3d(double)>& curve, double radius, int segments,
                             int sides) {
  std::vector<ConvexPart> parts;
  for (int i = 0; i < segments; ++i) {
    PointList list;
    for (const int end : {i, i + 1}) {
      const double t = static_cast<double>(end % segments) / segments;
      const Eigen::Vector3d tangent = (curve(t + 1e-5) - curve(t - 1e-5)).normalized();
      const Eigen::Vector3d u = tangent.cross(Eigen::Vector3d::UnitZ()).normalized();
      add_circle(list, sides, radius, curve(t), u, tangent.cross(u));
    }
    parts.push_back(hull_of(list));
  }
  return parts;
}

std::vector<ConvexPart> make_torus() {
  const auto circle = [](double t) {
    return Eigen::Vector3d(0.6 * std::cos(2 * M_PI * t), 0.6 * std::sin(2 * M_PI * t), 0);
  };
  return tube(circle, 0.15, 16, 12);
}

/// Makes the (2, 3) torus knot.
std::vector<ConvexPart> make_torus_knot() {
  const auto knot = [](double t) {
    const double angle = 2 * M_PI * t;
    const double r = 0.42 + 0.2 * std::cos(3 * angle);
    return Eigen::Vector3d(r * std::cos(2 * angle), r * std::sin(2 * angle), 0.24 * std::sin(3 * angle));
  };
  return tube(knot, 0.11, 30, 10);
}

/// Makes a ring of blocks with a hole for the axle, in which every second block carries a tooth.
std::vector<ConvexPart> make_gear() {
  constexpr int kBlocks = 16;              // blocks of the ring; chosen by eye, as the other sizes
  constexpr double kHalfThickness = 0.14;  // [m] near KuBasic's gear; chosen by eye
  const auto sector = [](int block, double inner, double outer, double narrow) {
    PointList list;
    for (const double side : {-0.5 * narrow, 0.5 * narrow}) {
      const double angle = 2 * M_PI * (block + side) / kBlocks;
      const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0);
      for (const double radius : {inner, outer}) {
        for (const double z : {-kHalfThickness, kHalfThickness}) {
          list.push_back(radius * direction + Eigen::Vector3d(0, 0, z));
        }
      }
    }
    return hull_of(list);
  };
  std::vector<ConvexPart> parts;
  for (int block = 0; block < kBlocks; ++block) parts.push_back(sector(block, 0.2, 0.56, 1.0));
  for (int block = 0; block < kBlocks; block += 2) parts.push_back(sector(block, 0.54, 0.75, 0.8));
  return parts;
}

/// Makes a Menger sponge of level 1, which has 20 of 27 cells.
std::vector<ConvexPart> make_sponge() {
  std::vector<ConvexPart> parts;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (std::abs(x) + std::abs(y) + std::abs(z) < 2) continue;
        parts.push_back(box(Eigen::Vector3d(x, y, z) / 3.0, Eigen::Vector3d::Constant(1.0 / 6.0)));
      }
    }
  }
  return parts;
}

/// Makes an ellipsoid with low bumps; the hull makes it convex.
std::vector<ConvexPart> make_pebble() {
  PointList list = ellipsoid(96, Eigen::Vector3d::Zero(), {0.62, 0.46, 0.3});
  for (Eigen::Vector3d& p : list) p *= 1.0 + 0.08 * std::sin(5.0 * p.x() + 1.0) * std::cos(4.0 * p.y() - 0.5);
  return {hull_of(list)};
}

std::vector<ConvexPart> make_pear() {
  return revolve({{-0.5, 0.18},
                  {-0.42, 0.33},
                  {-0.25, 0.44},
                  {-0.05, 0.44},
                  {0.15, 0.33},
                  {0.35, 0.2},
                  {0.55, 0.16},
                  {0.65, 0.07}},
                 16);
}

/// Makes a shaft with two knobs at each end.
std::vector<ConvexPart> make_bone() {
  std::vector<ConvexPart> parts = revolve({{-0.5, 0.15}, {0.0, 0.11}, {0.5, 0.15}}, 12);
  for (const double z : {-0.55, 0.55}) {
    for (const double x : {-0.15, 0.15}) parts.push_back(hull_of(ellipsoid(40, {x, 0, z}, {0.19, 0.17, 0.17})));
  }
  return parts;
}

/// Volume [m^3] and first moment [m^4] of a part, as the sum over tetrahedra from the origin.
std::pair<double, Eigen::Vector3d> volume_and_moment(const ConvexPart& part) {
  double volume = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (Eigen::Index f = 0; f < part.triangles.rows(); ++f) {
    const Eigen::Vector3d a = part.vertices.row(part.triangles(f, 0)).cast<double>();
    const Eigen::Vector3d b = part.vertices.row(part.triangles(f, 1)).cast<double>();
    const Eigen::Vector3d c = part.vertices.row(part.triangles(f, 2)).cast<double>();
    const double tetrahedron = a.dot(b.cross(c)) / 6.0;
    volume += tetrahedron;
    moment += tetrahedron * (a + b + c) / 4.0;
  }
  return {volume, moment};
}

/// Moves the parts so that their centre of mass is the origin. Parts that overlap do so symmetrically, so that
/// counting them twice does no harm.
Shape finish(std::string name, std::vector<ConvexPart> parts) {
  double volume = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const ConvexPart& part : parts) {
    const auto [part_volume, part_moment] = volume_and_moment(part);
    volume += part_volume;
    moment += part_moment;
  }
  const Eigen::RowVector3f centre = (moment / volume).cast<float>().transpose();
  for (ConvexPart& part : parts) part.vertices.rowwise() -= centre;
  const double known_mass = movi_shape_mass(name);
  return {std::move(name), known_mass > 0.0 ? known_mass : volume, std::move(parts)};
}

}  // namespace

const std::vector<Shape>& builtin_shapes() {
  static const std::vector<Shape> shapes = {
      finish("bone", make_bone()),
      finish("cone", revolve({{0.0, 0.6}, {1.2, 0.0}}, 63)),
      finish("cube", make_cube()),
      finish("cylinder", revolve({{-0.5, 0.5}, {0.5, 0.5}}, 32)),
      finish("gear", make_gear()),
      finish("pear", make_pear()),
      finish("pebble", make_pebble()),
      finish("sphere", {hull_of(ellipsoid(64, Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(0.5)))}),
      finish("sponge", make_sponge()),
      finish("torus", make_torus()),
      finish("torus_knot", make_torus_knot())};
  return shapes;
}

Symmetry symmetry_of(const std::string& shape) {
  if (shape == "sphere") return Symmetry::kAll;
  const bool of_revolution = shape == "cone" || shape == "cylinder" || shape == "pear" || shape == "torus";
  return of_revolution ? Symmetry::kAxis : Symmetry::kNone;
}

double visible_angle(const std::string& shape, const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Symmetry symmetry = symmetry_of(shape);
  if (symmetry == Symmetry::kAll) return 0.0;
  if (symmetry == Symmetry::kNone) return rotation_angle(a, b);
  const Eigen::Vector3d axis_a = a * Eigen::Vector3d::UnitZ(), axis_b = b * Eigen::Vector3d::UnitZ();
  return std::atan2(axis_a.cross(axis_b).norm(), axis_a.dot(axis_b));
}

}  // namespace rigidformer
