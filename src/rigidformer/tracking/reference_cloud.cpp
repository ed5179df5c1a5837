// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/reference_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "rigidformer/geometry/point_rows.hpp"

namespace rigidformer {

namespace {

// Thresholds, as in the table of docs/tracking.md ("All thresholds"): h is the voxel. "By eye": chosen by eye.
constexpr double kOutlierSpacing = 3.0;  // median spacings from its neighbours to an outlier of the first cloud; by eye
constexpr double kNoiseSpacing = 2.5;    // [noise] spacing below which reference points share no normal; by eye
constexpr double kExtentShare = 0.95;    // share of the points within half the object's size; by eye
constexpr std::size_t kMaxAveraged = 8;  // points averaged into a sample, which then cannot drift; by eye
constexpr double kSamePlace = 0.7;       // [h] from the nearest reference point: known surface; by eye
constexpr double kReach = 2.5;           // [h] from the nearest reference point: joins the known surface; by eye
constexpr int kChain = 2;                // [voxels] between places of new surface that belong together; by eye
constexpr int kSightings = 3;            // points at a place and its neighbours that are no stray ones; by eye
constexpr double kCoverage = 1.0;        // points at a place, over what a surface leaves in a voxel; derived
constexpr int kForgetAfter = 5;          // clouds after which a place that none shows is dropped; by eye
constexpr int kFaceNeighbors = 5;        // nearest reference points searched for one of the right face; by eye
constexpr double kRebuildShare = 0.06;   // new over known points that are worth a rebuild; by eye, for speed
constexpr double kCoarsening = 1.3;      // growth of h where the reference has too many points; by eye
constexpr double kMaxCell = 1e9;  // [voxels] derived: fits 32 bits; stray points beyond share the outermost cells

double quantile(std::vector<double> values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

SurfaceCloud without_outliers(const SurfaceCloud& cloud, const std::vector<double>& spacing) {
  const double limit = kOutlierSpacing * quantile(spacing, 0.5);
  std::vector<int> rows;
  for (std::size_t i = 0; i < spacing.size(); ++i) {
    if (spacing[i] <= limit) {
      rows.push_back(static_cast<int>(i));
    }
  }
  return 2 * rows.size() > spacing.size()
             ? SurfaceCloud{select_rows(cloud.points, rows), select_rows(cloud.normals, rows)}
             : cloud;
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

void ReferenceCloud::Sample::add(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) {
  if (points.size() < kMaxAveraged) {
    points.push_back(point);
    sum += point;
    normal_sum += normal_sum.dot(normal) < 0.0F ? Eigen::Vector3f(-normal) : normal;
  }
}

Eigen::Vector3f ReferenceCloud::Sample::normal() const {
  return normal_sum.isZero() ? normal_sum : Eigen::Vector3f(normal_sum.normalized());
}

ReferenceCloud::ReferenceCloud(const SurfaceCloud& cloud_object, const CorrespondenceOptions& parameters)
    : parameters_(parameters), tree_(cloud_object.points) {
  const std::vector<double> spacing = neighbor_spacing(tree_);
  const SurfaceCloud cloud = without_outliers(cloud_object, spacing);
  size_m_ = diameter(cloud.points);
  // If voxels were finer than the clouds, two clouds would seldom meet in one.
  voxel_size_m_ =
      std::max({parameters_.voxel_size * size_m_, quantile(spacing, 0.5), kNoiseSpacing * parameters_.noise});
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    samples_.emplace_back();
    samples_.back().add(cloud.points.row(i).transpose(), cloud.normals.row(i).transpose());
  }
  samples_ = thin(samples_);
  rebuild();
}

int ReferenceCloud::nearest(const Eigen::Vector3f& point_object, const Eigen::Vector3f& normal_object) const {
  const auto fits = [&](int row) { return on_same_face(normals_.row(row).transpose(), normal_object); };
  const int closest = tree_.nearest(point_object);
  if (normal_object.isZero() || fits(closest)) {
    return closest;
  }
  std::array<int, kFaceNeighbors> rows{};
  const auto end = rows.begin() + tree_.nearest(point_object, rows);
  const auto found = std::find_if(rows.begin(), end, fits);
  return found == end ? closest : *found;
}

const Eigen::Vector3f& ReferenceCloud::border(int row) const {
  std::optional<Eigen::Vector3f>& border = borders_[static_cast<std::size_t>(row)];
  if (!border) {
    border = find_border(tree_, normals_, row, size_m_);
  }
  return *border;
}

void ReferenceCloud::grow(const SurfaceCloud& cloud_object) {
  ++num_clouds_;
  for (Eigen::Index i = 0; i < cloud_object.points.rows(); ++i) {
    take_in(cloud_object.points.row(i).transpose(), cloud_object.normals.row(i).transpose());
  }
  // Stray points gather in coarse voxels too, but there are far fewer of them than points of a surface.
  const double per_voxel = static_cast<double>(cloud_object.points.rows()) * std::pow(voxel_size_m_ / size_m_, 2);
  accept_candidates(kCoverage * per_voxel);
}

void ReferenceCloud::take_in(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) {
  const int row = nearest(point, normal);
  const double distance = (points().row(row).transpose() - point).norm();
  const bool is_known_place = distance <= kSamePlace * voxel_size_m_;
  if (is_known_place && on_same_face(normals_.row(row).transpose(), normal)) {
    Sample& sample = samples_[static_cast<std::size_t>(row)];
    num_averaged_ += sample.points.size() < kMaxAveraged ? 1 : 0;
    sample.add(point, normal);
  } else if (distance <= size_m_ && !(is_known_place && normal.isZero())) {
    remember(point, normal);
  }
}

void ReferenceCloud::remember(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) {
  const VoxelKey key = key_of(point);
  auto [it, end] = candidates_.equal_range(key);
  while (it != end && !on_same_face(it->second.sample.normal(), normal)) {
    ++it;
  }
  if (it == end) {
    it = candidates_.insert({key, Candidate()});
  }
  it->second.last_cloud = num_clouds_;
  ++it->second.num_points;
  it->second.sample.add(point, normal);
}

template <class Visit>
void ReferenceCloud::visit_candidates(const VoxelKey& centre, int reach, const Visit& visit) const {
  for (int x = centre[0] - reach; x <= centre[0] + reach; ++x) {
    for (int y = centre[1] - reach; y <= centre[1] + reach; ++y) {
      const auto end = candidates_.upper_bound({x, y, centre[2] + reach});
      for (auto it = candidates_.lower_bound({x, y, centre[2] - reach}); it != end; ++it) {
        visit(it->first, it->second);
      }
    }
  }
}

std::set<ReferenceCloud::VoxelKey> ReferenceCloud::supported_candidates(double min_points) const {
  std::set<VoxelKey> supported;
  for (const auto& entry : candidates_) {
    int sightings = 0;
    visit_candidates(entry.first, 1,
                     [&](const VoxelKey&, const Candidate& candidate) { sightings += candidate.num_points; });
    if (sightings >= kSightings && entry.second.num_points >= min_points) {
      supported.insert(entry.first);
    }
  }
  return supported;
}

// The chain leads from the known surface outward, because a side that turns into view at once is wide.
std::vector<ReferenceCloud::VoxelKey> ReferenceCloud::connected_candidates(double min_points) const {
  const std::set<VoxelKey> supported = supported_candidates(min_points);
  std::set<VoxelKey> reached;
  std::vector<VoxelKey> chain;
  for (const auto& [key, candidate] : candidates_) {
    const Eigen::Vector3f place = candidate.sample.mean();
    const float distance = (points().row(tree_.nearest(place)).transpose() - place).norm();
    if (supported.count(key) == 1 && distance <= kReach * voxel_size_m_ && reached.insert(key).second) {
      chain.push_back(key);
    }
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const VoxelKey centre = chain[i];
    visit_candidates(centre, kChain, [&](const VoxelKey& key, const Candidate&) {
      if (supported.count(key) == 1 && reached.insert(key).second) {
        chain.push_back(key);
      }
    });
  }
  return chain;
}

void ReferenceCloud::accept_candidates(double min_points) {
  for (auto it = candidates_.begin(); it != candidates_.end();) {
    it = it->second.last_cloud + kForgetAfter <= num_clouds_ ? candidates_.erase(it) : std::next(it);
  }
  const std::vector<VoxelKey> accepted = connected_candidates(min_points);
  const bool has_grown = static_cast<double>(accepted.size()) > kRebuildShare * static_cast<double>(samples_.size());
  if (!has_grown && num_averaged_ < static_cast<int>(samples_.size())) {
    return;
  }
  for (const VoxelKey& key : accepted) {
    const auto [first, last] = candidates_.equal_range(key);
    std::transform(first, last, std::back_inserter(samples_), [](const auto& entry) { return entry.second.sample; });
    candidates_.erase(first, last);
  }
  rebuild();
}

void ReferenceCloud::rebuild() {
  while (samples_.size() > static_cast<std::size_t>(parameters_.max_reference_points)) {
    voxel_size_m_ *= kCoarsening;
    samples_ = thin(samples_);
    candidates_.clear();  // they were sorted into voxels of the old size
  }
  Points points(static_cast<Eigen::Index>(samples_.size()), 3);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    points.row(static_cast<Eigen::Index>(i)) = samples_[i].mean().transpose();
  }
  size_m_ = std::max(size_m_, diameter(points));
  tree_ = PointTree(std::move(points));
  normals_.resize(tree_.points().rows(), 3);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    normals_.row(static_cast<Eigen::Index>(i)) = samples_[i].normal().transpose();
  }
  borders_.assign(samples_.size(), std::nullopt);
  num_averaged_ = 0;
}

ReferenceCloud::VoxelKey ReferenceCloud::key_of(const Eigen::Vector3f& point) const {
  const Eigen::Array3d cell = (point.cast<double>() / voxel_size_m_).array().floor().max(-kMaxCell).min(kMaxCell);
  return {static_cast<int>(cell.x()), static_cast<int>(cell.y()), static_cast<int>(cell.z())};
}

// Keeps one sample per voxel and face.
std::vector<ReferenceCloud::Sample> ReferenceCloud::thin(const std::vector<Sample>& samples) const {
  std::multimap<VoxelKey, Sample> voxels;
  for (const Sample& sample : samples) {
    const VoxelKey key = key_of(sample.mean());
    auto [it, end] = voxels.equal_range(key);
    while (it != end && !on_same_face(it->second.normal(), sample.normal())) {
      ++it;
    }
    if (it == end) {
      it = voxels.insert({key, Sample()});
    }
    it->second.add(sample.mean(), sample.normal());
  }
  std::vector<Sample> thinned;
  for (const auto& [key, sample] : voxels) {
    thinned.push_back(sample);
  }
  return thinned;
}

}  // namespace rigidformer
