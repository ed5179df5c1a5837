// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/observed_hull.hpp"

#include "rigidformer/simulation/convex_hull.hpp"
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {
namespace {

constexpr double kOneSided = 0.15;  // distance of the two centres, in radii of the cloud around its centre of mass

Points with_mirror_images(const Points& points) {
  Points both(2 * points.rows(), 3);
  both << points, -points;
  return both;
}

}  // namespace

ObservedHull observe_hull(const Points& points, const Eigen::Vector3d& centre_of_mass) {
  const Points centred = with_thickness(points.rowwise() - centre_of_mass.cast<float>().transpose());
  ObservedHull observed{convex_hull(centred), 0.0};
  MeshVolume measured = measure_volume(observed.hull);
  if (measured.centroid.norm() > kOneSided * static_cast<double>(centred.rowwise().norm().maxCoeff())) {
    observed.hull = convex_hull(with_mirror_images(centred));
    measured = measure_volume(observed.hull);
  }
  observed.volume_m3 = measured.volume_m3;
  return observed;
}

}  // namespace rigidformer
