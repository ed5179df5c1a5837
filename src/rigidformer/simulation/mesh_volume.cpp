// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/mesh_volume.hpp"

namespace rigidformer {

MeshVolume measure_volume(const ConvexPart& mesh) {
  // The volume is summed over tetrahedra between the faces and the mean of the vertices; those of faces that look
  // at the mean count as negative.
  const Eigen::Vector3d apex = mesh.vertices.cast<double>().colwise().mean().transpose();
  MeshVolume sum;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    Eigen::Matrix3d corners;  // columns are corners
    for (int k = 0; k < 3; ++k) corners.col(k) = mesh.vertices.row(mesh.triangles(f, k)).transpose().cast<double>();
    const double volume = (corners.colwise() - apex).eval().determinant() / 6.0;
    sum.volume_m3 += volume;
    sum.centroid += volume * (apex + corners.rowwise().sum()) / 4.0;
  }
  sum.centroid /= sum.volume_m3;
  return sum;
}

MeshVolume measure_volume(const std::vector<ConvexPart>& parts) {
  MeshVolume sum;
  for (const ConvexPart& part : parts) {
    const MeshVolume of_part = measure_volume(part);
    sum.volume_m3 += of_part.volume_m3;
    sum.centroid += of_part.volume_m3 * of_part.centroid;
  }
  sum.centroid /= sum.volume_m3;
  return sum;
}

Eigen::Matrix3d inertia_per_mass(const ConvexPart& mesh) {
  // The second moments of a tetrahedron between the origin and a face with corners p_i are
  // volume / 20 * (sum of p_i p_i^T + s s^T) with s = sum of p_i.
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double volume_m3 = 0.0;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    Eigen::Matrix3d corners;  // columns are corners
    for (int k = 0; k < 3; ++k) corners.col(k) = mesh.vertices.row(mesh.triangles(f, k)).transpose().cast<double>();
    const double volume = corners.determinant() / 6.0;
    const Eigen::Vector3d sum = corners.rowwise().sum();
    volume_m3 += volume;
    moments += volume / 20.0 * (corners * corners.transpose() + sum * sum.transpose());
  }
  moments /= volume_m3;
  return moments.trace() * Eigen::Matrix3d::Identity() - moments;
}

}  // namespace rigidformer
