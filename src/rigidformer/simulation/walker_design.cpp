// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "walker_design.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "convex_hull.hpp"

namespace rigidformer {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kSquareness = 6.0;  // exponent of the superellipsoid that rounds a box; chosen by eye

/// One segment of a leg in its vertical plane.
struct Segment {
  const char* shape;
  double length_m, elevation_deg, half_width_m, mass_kg;
};

/// Frame of a limb from `start` to `end`: x along it, y level.
RigidTransform along(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  const Eigen::Vector3d x = (end - start).normalized();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitZ().cross(x).normalized();
  Eigen::Matrix3d R;
  R << x, y, x.cross(y);
  return {Eigen::Quaterniond(R), 0.5 * (start + end)};
}

void add_leg(const std::vector<Segment>& segments, WalkerLeg leg, WalkerDesign& design) {
  const Eigen::Vector3d outward(std::cos(leg.outward_rad), std::sin(leg.outward_rad), 0.0);
  const Eigen::Vector3d lifting = outward.cross(Eigen::Vector3d::UnitZ());
  Eigen::Vector3d joint = leg.hip;
  int parent = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const double elevation = segment.elevation_deg * kDegree;
    const Eigen::Vector3d end =
        joint + segment.length_m * (std::cos(elevation) * outward + std::sin(elevation) * Eigen::Vector3d::UnitZ());
    const auto child = static_cast<int>(design.parts.size());
    const Eigen::Vector3d half_extents(0.5 * segment.length_m, segment.half_width_m, segment.half_width_m);
    design.parts.push_back({segment.shape, half_extents, segment.mass_kg, along(joint, end)});
    design.hinges.push_back({parent, child, joint, i == 0 ? Eigen::Vector3d::UnitZ().eval() : lifting});
    parent = child;
    joint = end;
  }
  const auto last = static_cast<int>(design.hinges.size()) - 1;
  leg.swing = last - static_cast<int>(segments.size()) + 1;
  leg.lift = leg.swing + 1;
  if (segments.size() == 3) leg.upright = last;
  leg.reach_m = (joint - leg.hip).dot(outward);
  design.height_m = -joint.z();
  design.legs.push_back(leg);
}

/// Pairs of legs along the torso; neighbours step in turns, and so do the two sides.
void add_legs(const std::vector<Segment>& segments, const std::vector<double>& places_m, double half_width_m,
              double spread_deg, WalkerDesign& design) {
  for (std::size_t i = 0; i < places_m.size(); ++i) {
    const double farthest_m = places_m.front();
    for (const int side : {1, -1}) {
      WalkerLeg leg;
      leg.hip = {places_m[i], side * half_width_m, 0.0};
      leg.outward_rad = side * (90.0 - spread_deg * places_m[i] / farthest_m) * kDegree;
      leg.phase = (i % 2 == 0) == (side > 0) ? 0.0 : 0.5;
      add_leg(segments, leg, design);
    }
  }
}

WalkerDesign make_walker_15() {
  WalkerDesign design;
  design.points_per_part = 256;
  design.parts.push_back({"torso", {0.45, 0.22, 0.08}, 6.0, {}});
  add_legs({{"coxa", 0.12, 0.0, 0.04, 0.3}, {"shin", 0.45, -55.0, 0.03, 0.5}}, {0.36, 0.0, -0.36}, 0.24, 30.0, design);
  const Eigen::Vector3d throat(0.34, 0.0, 0.08), nape(0.34, 0.0, 0.24);
  const auto neck = static_cast<int>(design.parts.size());
  design.parts.push_back({"neck", {0.05, 0.05, 0.08}, 0.3, {Eigen::Quaterniond::Identity(), 0.5 * (throat + nape)}});
  design.parts.push_back(
      {"head", {0.16, 0.08, 0.06}, 0.6, {Eigen::Quaterniond::Identity(), nape + Eigen::Vector3d(0.1, 0.0, 0.06)}});
  design.neck = static_cast<int>(design.hinges.size());
  design.hinges.push_back({0, neck, throat, Eigen::Vector3d::UnitZ()});
  design.hinges.push_back({neck, neck + 1, nape, Eigen::Vector3d::UnitY()});
  return design;
}

WalkerDesign make_walker_31() {
  WalkerDesign design;
  design.points_per_part = 212;  // some lie too flat to be corners of the hull
  design.parts.push_back({"torso", {0.8, 0.18, 0.07}, 8.0, {}});
  add_legs({{"coxa", 0.1, 0.0, 0.035, 0.25}, {"femur", 0.2, 25.0, 0.03, 0.3}, {"tibia", 0.42, -80.0, 0.025, 0.35}},
           {0.68, 0.34, 0.0, -0.34, -0.68}, 0.2, 15.0, design);
  return design;
}

/// Points on a rounded box, spread along a golden spiral.
Points rounded_box(const Eigen::Vector3d& half_extents_m, int count) {
  const double golden_angle = M_PI * (3.0 - std::sqrt(5.0));
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z);
    const Eigen::Vector3d direction(r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z);
    const double size = std::pow(direction.array().abs().pow(kSquareness).sum(), 1.0 / kSquareness);
    points.row(i) = (half_extents_m.array() * direction.array() / size).matrix().cast<float>().transpose();
  }
  return points;
}

}  // namespace

const WalkerDesign* walker_set(const std::string& name) {
  static const std::array<WalkerDesign, 2> designs{make_walker_15(), make_walker_31()};
  const auto& names = walker_set_names();
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : &designs[static_cast<std::size_t>(found - names.begin())];
}

const std::vector<std::string>& walker_set_names() {
  static const std::vector<std::string> names{"walker_15", "walker_31"};
  return names;
}

std::vector<Shape> walker_shapes(const WalkerDesign& design) {
  std::vector<Shape> shapes;
  for (const WalkerPart& part : design.parts) {
    const auto same = [&](const Shape& shape) { return shape.name == part.shape; };
    if (std::any_of(shapes.begin(), shapes.end(), same)) continue;
    const ConvexPart hull = convex_hull(rounded_box(part.half_extents_m, design.points_per_part));
    shapes.push_back({part.shape, part.mass_kg, {hull}});
  }
  return shapes;
}

}  // namespace rigidformer
