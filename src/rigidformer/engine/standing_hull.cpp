// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/standing_hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rigidformer/simulation/convex_hull.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"
#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {
namespace {

// Share of a body's size that may be hidden at its bottom: segment_cloud takes the lowest 8 mm of objects of 5 to 10 cm
// for the ground (plane_distance), and less of larger ones.
constexpr double kUnseenBottom = 0.1;
constexpr double kFloorNormal_z = 0.5;  // a surface steeper than 60 degrees carries nothing; chosen by eye

#ifdef RIGIDFORMER_HAS_BULLET

constexpr double kFootShare = 0.05;  // of the height: what is lower belongs to the foot; chosen by eye
constexpr double kFootMargin = 0.1;  // of the height of the centre of mass: stands in a tilt of 6 degrees; by eye
constexpr int kDirections = 16;      // in which the foot is measured: every 22.5 degrees; chosen by eye

using Outline = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;  ///< Horizontal, about the centre of mass

Eigen::Vector2d direction(int i) {
  const double angle = 2.0 * M_PI * i / kDirections;
  return {std::cos(angle), std::sin(angle)};
}

Outline joined(const Outline& a, const Outline& b) {
  Outline both(a.rows() + b.rows(), 2);
  both << a, b;
  return both;
}

/// What is missing of the foot for the centre of mass to be `margin_m` inside of it.
Outline missing(const Outline& foot, double margin_m) {
  std::vector<Eigen::Vector2d> found;
  for (int i = 0; i < kDirections; ++i) {
    if ((foot * direction(i)).maxCoeff() < margin_m) found.push_back(margin_m * direction(i));
  }
  Outline points(static_cast<Eigen::Index>(found.size()), 2);
  for (std::size_t i = 0; i < found.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = found[i].transpose();
  return points;
}

/// The foot of a body as it is seen: its lowest points.
Outline seen_foot(const Points& points) {
  const double lowest = static_cast<double>(points.col(2).minCoeff());
  const double high = lowest + kFootShare * (static_cast<double>(points.col(2).maxCoeff()) - lowest);
  Outline foot(0, 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (static_cast<double>(points(i, 2)) > high) continue;
    foot = joined(foot, points.row(i).head<2>().cast<double>());
  }
  return foot;
}

/// All points [V, 3] are seen from the centre of mass, in world axes.
ObservedSolid on_its_feet(const ObservedSolid& solid, const RigidTransform& T_world_body, double down_m,
                          const BodyProperties& properties) {
  const RigidTransform R{T_world_body.rotation, Eigen::Vector3d::Zero()};
  const Points points = R.apply(solid.hull->vertices);
  const double floor_m = static_cast<double>(points.col(2).minCoeff()) - down_m;
  const double margin_m = kFootMargin * std::abs(floor_m);
  Outline foot = seen_foot(points);
  if (missing(foot, margin_m).rows() > 0) {
    foot = joined(foot, -foot);  // the other side stands as the seen one does
    foot = joined(foot, missing(foot, margin_m));
  } else if (down_m < kTouching_m) {
    return solid;  // what rolls must keep its shape
  }
  Points all(points.rows() + foot.rows(), 3);
  all.topRows(points.rows()) = points;
  all.bottomRows(foot.rows()).leftCols<2>() = foot.cast<float>();
  all.bottomRows(foot.rows()).col(2).setConstant(static_cast<float>(floor_m));
  const ConvexPart hull = convex_hull(R.inverse().apply(all));
  return with_hull(solid, hull, measure_volume(hull).volume_m3, properties);
}

#endif

}  // namespace

double unseen_bottom_m(const ObservedSolid& solid) { return kUnseenBottom * 2.0 * solid.radius_m; }

std::vector<double> heights_above_support(const SolidScene& scene, const std::vector<RigidTransform>& T_world_body) {
  constexpr double kNothing_m = std::numeric_limits<double>::infinity();
  std::vector<double> nearest(scene.solids().size(), kNothing_m);
  double reach_m = 0.0;
  for (const ObservedSolid& solid : scene.solids()) reach_m = std::max(reach_m, unseen_bottom_m(solid));
  for (const SolidGap& gap : scene.gaps(T_world_body, reach_m)) {
    if (std::abs(gap.normal.z()) < kFloorNormal_z) continue;
    const auto upper = static_cast<std::size_t>(gap.normal.z() > 0.0 ? gap.body : gap.partner);
    if (gap.gap_m > unseen_bottom_m(scene.solids()[upper])) continue;
    nearest[upper] = std::min(nearest[upper], std::max(0.0, gap.gap_m));
  }
  return nearest;
}

std::vector<ObservedSolid> on_their_feet(const SolidScene& scene, const std::vector<RigidTransform>& T_world_body,
                                         const std::vector<bool>& stands,
                                         const std::vector<BodyProperties>& properties) {
  std::vector<ObservedSolid> solids = scene.solids();
#ifdef RIGIDFORMER_HAS_BULLET
  if (std::find(stands.begin(), stands.end(), true) == stands.end()) return solids;
  const std::vector<double> height_m = heights_above_support(scene, T_world_body);
  for (std::size_t k = 0; k < solids.size(); ++k) {
    const double down_m = std::isfinite(height_m[k]) ? height_m[k] : 0.0;
    if (stands[k]) solids[k] = on_its_feet(solids[k], T_world_body[k], down_m, properties[k]);
  }
#else
  (void)T_world_body, (void)stands, (void)properties;
#endif
  return solids;
}

}  // namespace rigidformer
