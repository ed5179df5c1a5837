// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/surface_cloud.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

namespace rigidformer {

namespace {

// Thresholds, as in the table of docs/tracking.md ("All thresholds"). "By eye": chosen by eye.
constexpr int kNormalNeighbors = 9;   // points that give a normal, the point itself included; by eye
constexpr float kFlat = 0.1F;         // smallest over middle variance of points on a plane, at most; by eye
constexpr float kSpread = 0.1F;       // middle over largest variance below which points lie on a line; by eye
constexpr float kSameFace = 0.7F;     // cosine between normals of one face, at least; by eye
constexpr float kOnPlane = 3.0F;      // [noise] from the plane of a neighbour; derived: 99.7 % of Gaussian noise
constexpr int kBorderNeighbors = 17;  // points that tell the end of a face, the point itself included; by eye
constexpr float kBorderGap = 2.1F;    // [rad] gap without neighbours; derived: 2/3 of what a straight end leaves
constexpr float kBend = 1.0F;         // [rad per size] bend beyond which the surface may go on out of view; by eye
constexpr float kFullTurn = 2.0F * static_cast<float>(M_PI);  // [rad] a whole turn

Eigen::Vector3f fit_normal(const Points& points, const std::vector<int>& rows) {
  Eigen::Matrix<float, kNormalNeighbors, 3> offsets;
  for (int k = 0; k < kNormalNeighbors; ++k) {
    offsets.row(k) = points.row(rows[static_cast<std::size_t>(k)]) - points.row(rows.front());
  }
  offsets.rowwise() -= offsets.colwise().mean().eval();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(Eigen::Matrix3f(offsets.transpose() * offsets));
  const Eigen::Vector3f& variances = solver.eigenvalues();
  const bool is_flat = variances[0] < kFlat * variances[1] && variances[1] > kSpread * variances[2];
  return is_flat ? Eigen::Vector3f(solver.eigenvectors().col(0)) : Eigen::Vector3f::Zero();
}

// Takes the normal of the neighbour whose plane passes closest, if that is close enough.
Eigen::Vector3f borrow_normal(const SurfaceCloud& cloud, const std::vector<int>& rows, double noise_m) {
  const Eigen::RowVector3f point = cloud.points.row(rows.front());
  Eigen::RowVector3f normal = Eigen::RowVector3f::Zero();
  float closest = kOnPlane * static_cast<float>(noise_m);
  for (const int row : rows) {
    const float distance = std::abs(cloud.normals.row(row).dot(point - cloud.points.row(row)));
    if (!cloud.normals.row(row).isZero() && distance < closest) {
      closest = distance;
      normal = cloud.normals.row(row);
    }
  }
  return normal.transpose();
}

// Sets `middle` to the middle of the widest gap between directions in a plane, given as angles [rad]; false where
// the directions lie all around.
bool find_gap(std::vector<float>& angles, float& middle) {
  std::sort(angles.begin(), angles.end());
  float widest = kBorderGap;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const float next = i + 1 < angles.size() ? angles[i + 1] : angles.front() + kFullTurn;
    if (next - angles[i] > widest) {
      widest = next - angles[i];
      middle = 0.5F * (angles[i] + next);
    }
  }
  return widest > kBorderGap;
}

// One point of a surface with its neighbours on the same face.
class Patch {
 public:
  Patch(const PointTree& tree, const Points& normals, Eigen::Index row) : normal_(normals.row(row).transpose()) {
    const Eigen::Vector3f point = tree.points().row(row).transpose();
    std::vector<int> rows;
    tree.nearest(point, kBorderNeighbors, rows);
    for (const int other : rows) {
      const Eigen::Vector3f normal = normals.row(other).transpose();
      if (other != row && on_same_face(normal, normal_)) {
        offsets_.push_back(tree.points().row(other).transpose() - point);
        normals_.push_back(normal.dot(normal_) < 0.0F ? Eigen::Vector3f(-normal) : normal);
      }
    }
  }

  // Outward direction at the end of the face; zero where the face goes on all around.
  Eigen::Vector3f outward() const {
    const Eigen::Vector3f u = normal_.unitOrthogonal();
    const Eigen::Vector3f v = normal_.cross(u);
    std::vector<float> angles;
    for (const Eigen::Vector3f& offset : offsets_) {
      angles.push_back(std::atan2(offset.dot(v), offset.dot(u)));
    }
    float middle = 0.0F;
    return angles.size() >= 3 && find_gap(angles, middle) ? Eigen::Vector3f(std::cos(middle) * u + std::sin(middle) * v)
                                                          : Eigen::Vector3f::Zero();
  }

  // Bend of the surface behind the point, straight back from the end: turn of the normals per length [1/m].
  float bend(const Eigen::Vector3f& outward) const {
    float turn = 0.0F;
    float way = 0.0F;
    for (std::size_t i = 0; i < offsets_.size(); ++i) {
      const float behind = -offsets_[i].dot(outward);
      if (behind > 0.5F * offsets_[i].norm()) {
        turn += (normals_[i] - normal_).dot(outward);
        way += behind;
      }
    }
    return way > 0.0F ? std::abs(turn) / way : 0.0F;
  }

 private:
  Eigen::Vector3f normal_;
  std::vector<Eigen::Vector3f> offsets_;
  std::vector<Eigen::Vector3f> normals_;  // With the signs that agree with normal_
};

}  // namespace

Points thin(const Points& points, Eigen::Index count) {
  if (points.rows() <= count) {
    return points;
  }
  Points thinned(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    thinned.row(i) = points.row(i * points.rows() / count);
  }
  return thinned;
}

SurfaceCloud thin(const SurfaceCloud& cloud, Eigen::Index count) {
  return {thin(cloud.points, count), thin(cloud.normals, count)};
}

SurfaceCloud transform(const RigidTransform& T_b_a, const SurfaceCloud& cloud_a) {
  const Eigen::Matrix3d R = T_b_a.rotation.toRotationMatrix();
  const Eigen::RowVector3d shift = T_b_a.translation.transpose();
  return {((cloud_a.points.cast<double>() * R.transpose()).rowwise() + shift).cast<float>(),
          (cloud_a.normals.cast<double>() * R.transpose()).cast<float>()};
}

bool on_same_face(const Eigen::Vector3f& normal_a, const Eigen::Vector3f& normal_b) {
  return (normal_a.isZero() && normal_b.isZero()) || std::abs(normal_a.dot(normal_b)) > kSameFace;
}

SurfaceCloud estimate_surface(const Points& points, double noise_m) {
  SurfaceCloud cloud{points, Points::Zero(points.rows(), 3)};
  if (points.rows() < kNormalNeighbors) {
    return cloud;
  }
  const PointTree tree(points);
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    std::vector<int>& neighbors = rows[static_cast<std::size_t>(i)];
    tree.nearest(points.row(i).transpose(), kNormalNeighbors, neighbors);
    cloud.normals.row(i) = fit_normal(points, neighbors).transpose();
  }
  const SurfaceCloud flat = cloud;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (flat.normals.row(i).isZero()) {
      cloud.normals.row(i) = borrow_normal(flat, rows[static_cast<std::size_t>(i)], noise_m).transpose();
    }
  }
  return cloud;
}

Eigen::Vector3f find_border(const PointTree& tree, const Points& normals, Eigen::Index row, double size_m) {
  if (normals.row(row).isZero()) {
    return Eigen::Vector3f::Zero();
  }
  const Patch patch(tree, normals, row);
  const Eigen::Vector3f outward = patch.outward();
  const bool bends_away = patch.bend(outward) * static_cast<float>(size_m) >= kBend;
  return bends_away ? Eigen::Vector3f::Zero() : outward;
}

}  // namespace rigidformer
