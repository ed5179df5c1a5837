// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/observed_hull.hpp"

#include "rigidformer/simulation/convex_hull.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {
namespace {

constexpr double kOneSided = 0.10;  // distance of the two centres, in radii of the cloud around its centre of mass

Points joined(const Points& a, const Points& b) {
  Points both(a.rows() + b.rows(), 3);
  both << a, b;
  return both;
}

}  // namespace

ObservedHull observe_hull(const Points& points, const Eigen::Vector3d& centre_of_mass, const Points& hidden) {
  const Eigen::RowVector3f centre = centre_of_mass.cast<float>().transpose();
  const Points centred = with_thickness(points.rowwise() - centre);
  ObservedHull observed{convex_hull(centred), centre_of_mass, 0.0, false};
  const MeshVolume seen = measure_volume(observed.hull);
  if (seen.centroid.norm() > kOneSided * static_cast<double>(centred.rowwise().norm().maxCoeff())) {
    const Points other_side = hidden.rows() > 0 ? Points(hidden.rowwise() - centre) : Points(-centred);
    observed.hull = convex_hull(joined(centred, other_side));
    observed.volume_m3 = measure_volume(observed.hull).volume_m3;
    return observed;
  }
  observed.hull.vertices.rowwise() -= seen.centroid.cast<float>().transpose();
  observed.centre_of_mass += seen.centroid;
  observed.volume_m3 = seen.volume_m3;
  observed.complete = true;
  return observed;
}

}  // namespace rigidformer
