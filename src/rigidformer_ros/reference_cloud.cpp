// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/reference_cloud.hpp"

#include <algorithm>
#include <cmath>

#include "rigidformer_ros/cloud_conversion.hpp"

namespace rigidformer_ros {

namespace {

constexpr double kOutlierSpacing = 3.0;  // times the median spacing: so far from its neighbours, a point is an outlier
constexpr double kNoiseSpacing = 2.5;    // [noise] between reference points: closer ones have no common normal
constexpr double kExtentShare = 0.95;    // of the points lie within the object's radius
constexpr int kMaxAveraged = 8;          // points of a sample that are averaged; then it stands still and cannot drift
constexpr double kSamePlace = 0.7;       // [voxel] from the nearest reference point: known surface
constexpr double kReach = 2.5;           // [voxel] from it: still a continuation
constexpr int kCloudsToBeKnown = 2;      // in which new surface must be seen
constexpr int kForgetAfter = 5;          // clouds without a second sight of it
constexpr double kRebuildShare = 0.04;   // new points per known point that are worth a rebuild
constexpr double kCoarsening = 1.3;
constexpr double kMaxCell = 1e9;  // stray points beyond share the outermost cells

double quantile(std::vector<double> values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

Points without_outliers(const Points& points, const std::vector<double>& spacing) {
  const double limit = kOutlierSpacing * quantile(spacing, 0.5);
  std::vector<int> rows;
  for (std::size_t i = 0; i < spacing.size(); ++i) {
    if (spacing[i] <= limit) {
      rows.push_back(static_cast<int>(i));
    }
  }
  return 2 * rows.size() > spacing.size() ? select_rows(points, rows) : points;
}

double diameter(const Points& points) {
  const Eigen::RowVector3f centroid = points.colwise().mean();
  std::vector<double> radii;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    radii.push_back((points.row(i) - centroid).norm());
  }
  return 2.0 * quantile(radii, kExtentShare);
}

}  // namespace

void ReferenceCloud::Sample::add(const Eigen::Vector3f& point) {
  if (count < kMaxAveraged) {
    sum += point;
    ++count;
  }
}

ReferenceCloud::ReferenceCloud(const Points& points_object, const CorrespondenceParameters& parameters)
    : parameters_(parameters), tree_(points_object) {
  const std::vector<double> spacing = neighbor_spacing(tree_);
  const Points points = without_outliers(points_object, spacing);
  size_m_ = diameter(points);
  // Finer than the clouds themselves, two clouds would seldom meet in a voxel.
  voxel_size_m_ =
      std::max({parameters_.voxel_size * size_m_, quantile(spacing, 0.5), kNoiseSpacing * parameters_.noise});
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    samples_.push_back({points.row(i).transpose(), 1});
  }
  samples_ = thin(samples_);
  rebuild();
}

void ReferenceCloud::grow(const Points& points_object) {
  ++num_clouds_;
  for (Eigen::Index i = 0; i < points_object.rows(); ++i) {
    take_in(points_object.row(i).transpose());
  }
  accept_candidates();
}

void ReferenceCloud::take_in(const Eigen::Vector3f& point) {
  const int row = nearest(point);
  const double distance = (points().row(row).transpose() - point).norm();
  if (distance <= kSamePlace * voxel_size_m_) {
    Sample& sample = samples_[static_cast<std::size_t>(row)];
    num_averaged_ += sample.count < kMaxAveraged ? 1 : 0;
    sample.add(point);
  } else if (distance <= kReach * voxel_size_m_) {
    Candidate& candidate = candidates_[key_of(point)];
    candidate.clouds += candidate.last_cloud < num_clouds_ ? 1 : 0;
    candidate.last_cloud = num_clouds_;
    candidate.sample.add(point);
  }
}

void ReferenceCloud::accept_candidates() {
  std::size_t num_ready = 0;
  for (auto it = candidates_.begin(); it != candidates_.end();) {
    const bool ready = it->second.clouds >= kCloudsToBeKnown;
    num_ready += ready ? 1 : 0;
    it = !ready && it->second.last_cloud + kForgetAfter <= num_clouds_ ? candidates_.erase(it) : std::next(it);
  }
  const bool has_grown = static_cast<double>(num_ready) > kRebuildShare * static_cast<double>(samples_.size());
  if (!has_grown && num_averaged_ < static_cast<int>(samples_.size())) {
    return;
  }
  for (auto it = candidates_.begin(); it != candidates_.end();) {
    if (it->second.clouds >= kCloudsToBeKnown) {
      samples_.push_back(it->second.sample);
      it = candidates_.erase(it);
    } else {
      ++it;
    }
  }
  rebuild();
}

void ReferenceCloud::rebuild() {
  while (samples_.size() > static_cast<std::size_t>(parameters_.max_reference_points)) {
    voxel_size_m_ *= kCoarsening;
    samples_ = thin(samples_);
    candidates_.clear();  // their places were cut to the old size
  }
  Points points(static_cast<Eigen::Index>(samples_.size()), 3);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    points.row(static_cast<Eigen::Index>(i)) = samples_[i].mean().transpose();
  }
  size_m_ = std::max(size_m_, diameter(points));
  tree_ = PointTree(std::move(points));
  normals_ = estimate_normals(tree_);
  num_averaged_ = 0;
}

ReferenceCloud::VoxelKey ReferenceCloud::key_of(const Eigen::Vector3f& point) const {
  const Eigen::Array3d cell = (point.cast<double>() / voxel_size_m_).array().floor().max(-kMaxCell).min(kMaxCell);
  return {static_cast<int>(cell.x()), static_cast<int>(cell.y()), static_cast<int>(cell.z())};
}

// One sample per voxel.
std::vector<ReferenceCloud::Sample> ReferenceCloud::thin(const std::vector<Sample>& samples) const {
  std::map<VoxelKey, Sample> voxels;
  for (const Sample& sample : samples) {
    voxels[key_of(sample.mean())].add(sample.mean());
  }
  std::vector<Sample> thinned;
  for (const auto& [key, sample] : voxels) {
    thinned.push_back(sample);
  }
  return thinned;
}

}  // namespace rigidformer_ros
