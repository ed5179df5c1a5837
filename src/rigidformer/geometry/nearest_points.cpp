// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/geometry/nearest_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace rigidformer {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr std::size_t kLeafSize = 8;  // points per leaf of a search tree; changes the speed only; chosen by eye

/// A rigid motion in single precision, for the inner loops.
struct FloatTransform {
  Eigen::Matrix3f rotation;
  Eigen::Vector3f translation;

  explicit FloatTransform(const RigidTransform& T)
      : rotation(T.rotation.toRotationMatrix().cast<float>()), translation(T.translation.cast<float>()) {}
};

/// Keeps the single best point. It starts from a bound, so that the tree is only entered where it can improve on it.
struct BestPoint {
  float squared_distance;
  int index = -1;

  float worstDist() const { return squared_distance; }
  bool full() const { return index >= 0; }
  bool addPoint(float candidate, int candidate_index) {
    if (candidate < squared_distance) {
      squared_distance = candidate;
      index = candidate_index;
    }
    return true;
  }
};

}  // namespace

/// With its bounds, all in the cloud's own frame.
class SearchableCloud {
 public:
  explicit SearchableCloud(Points points)
      : points_(std::move(points)), tree_(3, *this, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize)) {
    tree_.buildIndex();
    lower_ = points_.colwise().minCoeff();
    upper_ = points_.colwise().maxCoeff();
    centre_ = 0.5F * (lower_ + upper_);
    radius_ = std::sqrt((points_.rowwise() - centre_.transpose()).rowwise().squaredNorm().maxCoeff());
  }
  SearchableCloud(const SearchableCloud&) = delete;
  SearchableCloud& operator=(const SearchableCloud&) = delete;

  const Points& points() const { return points_; }
  const Eigen::Vector3f& centre() const { return centre_; }
  float radius() const { return radius_; }

  float squared_distance_to_box(const Eigen::Vector3f& query) const {
    return (lower_ - query).cwiseMax(query - upper_).cwiseMax(0.0F).squaredNorm();
  }
  void search(const Eigen::Vector3f& query, BestPoint& best) const { tree_.findNeighbors(best, query.data(), {}); }

  std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(points_.rows()); }
  float kdtree_get_pt(std::size_t row, std::size_t axis) const { return points_.data()[3 * row + axis]; }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

 private:
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, SearchableCloud>,
                                                   SearchableCloud, 3, int>;
  Points points_;
  Tree tree_;
  Eigen::Vector3f lower_, upper_, centre_;
  float radius_ = 0.0F;
};

class NearestPoints::Impl {
 public:
  explicit Impl(std::vector<std::shared_ptr<const SearchableCloud>> clouds) : clouds_(std::move(clouds)) {
    for (const auto& cloud : clouds_) {
      const auto count = static_cast<std::size_t>(cloud->points().rows());
      last_.push_back({std::vector<int>(count, -1), std::vector<int>(count, -1)});
    }
  }

  void query(const std::vector<RigidTransform>& poses, std::vector<NearestNeighbors>& nearest) {
    validate(poses);
    centres_world_.clear();
    for (std::size_t i = 0; i < clouds_.size(); ++i) {
      centres_world_.push_back(poses[i] * clouds_[i]->centre().cast<double>());
    }
    for (std::size_t i = 0; i < clouds_.size(); ++i) {
      start_from_last_answer(i, poses);
      sort_candidates(i);
      for (const auto& [lower_bound, j] : candidates_) {
        if (lower_bound > reach()) {
          break;
        }
        search_pair(i, j, poses);
      }
    }
    nearest = last_;
  }

 private:
  void validate(const std::vector<RigidTransform>& poses) const {
    if (poses.size() != clouds_.size()) {
      throw std::invalid_argument("nearest points: " + std::to_string(poses.size()) + " poses for " +
                                  std::to_string(clouds_.size()) + " clouds");
    }
    const auto bad = std::find_if_not(poses.begin(), poses.end(), is_valid);
    if (bad != poses.end()) {
      throw std::invalid_argument("nearest points: pose of cloud " + std::to_string(bad - poses.begin()) +
                                  " is not a finite rigid transform");
    }
  }

  /// Bounds the distances from above: the point that was nearest last time is still a point of another object.
  void start_from_last_answer(std::size_t i, const std::vector<RigidTransform>& poses) {
    const Points& points = clouds_[i]->points();
    best_.assign(points.rows(), kFar);
    to_own_frame_.assign(clouds_.size(), std::nullopt);  // of hundreds of objects a few are near: the rest stays empty
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
      const int j = last_[i].object[row];
      if (j >= 0) {
        std::optional<FloatTransform>& T_own_other = to_own_frame_[j];
        if (!T_own_other) T_own_other.emplace(poses[i].inverse() * poses[j]);
        const Eigen::Vector3f other = clouds_[j]->points().row(last_[i].point[row]);
        best_[row] =
            (T_own_other->rotation * other + T_own_other->translation - points.row(row).transpose()).squaredNorm();
      }
    }
  }

  /// Farthest that a nearest point of the searched object can still be [m].
  float reach() const { return std::sqrt(*std::max_element(best_.begin(), best_.end())); }

  /// Sorts the other objects in reach by the least distance that their bounding spheres allow.
  void sort_candidates(std::size_t i) {
    candidates_.clear();
    const float farthest = reach();
    for (std::size_t j = 0; j < clouds_.size(); ++j) {
      if (j == i) continue;
      const double gap = (centres_world_[j] - centres_world_[i]).norm();
      const float least = static_cast<float>(gap) - clouds_[i]->radius() - clouds_[j]->radius();
      if (least <= farthest) candidates_.emplace_back(least, j);
    }
    std::sort(candidates_.begin(), candidates_.end());
  }

  void search_pair(std::size_t i, std::size_t j, const std::vector<RigidTransform>& poses) {
    const FloatTransform T_other_own(poses[j].inverse() * poses[i]);
    const Points& points = clouds_[i]->points();
    const SearchableCloud& other = *clouds_[j];
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
      const Eigen::Vector3f query = T_other_own.rotation * points.row(row).transpose() + T_other_own.translation;
      if (other.squared_distance_to_box(query) >= best_[row]) {
        continue;
      }
      BestPoint best{best_[row]};
      other.search(query, best);
      if (best.full()) {
        best_[row] = best.squared_distance;
        last_[i].object[row] = static_cast<int>(j);
        last_[i].point[row] = best.index;
      }
    }
  }

  std::vector<std::shared_ptr<const SearchableCloud>> clouds_;
  std::vector<NearestNeighbors> last_;
  std::vector<float> best_;  ///< Squared nearest distances so far of the points of the searched object
  std::vector<Eigen::Vector3d> centres_world_;
  /// From the frames of others to that of the searched object; of those only that hold a last answer
  std::vector<std::optional<FloatTransform>> to_own_frame_;
  std::vector<std::pair<float, std::size_t>> candidates_;  ///< (least possible distance, object)
};

std::shared_ptr<const SearchableCloud> make_searchable(Points cloud) {
  if (cloud.rows() == 0 || !cloud.allFinite()) throw std::invalid_argument("the cloud is empty or not finite");
  return std::make_shared<SearchableCloud>(std::move(cloud));
}

NearestPoints::NearestPoints(std::vector<Points> clouds) {
  std::vector<std::shared_ptr<const SearchableCloud>> searchable;
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    try {
      searchable.push_back(make_searchable(std::move(clouds[i])));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("nearest points, cloud " + std::to_string(i) + ": " + error.what());
    }
  }
  impl_ = std::make_unique<Impl>(std::move(searchable));
}
NearestPoints NearestPoints::sharing(std::vector<std::shared_ptr<const SearchableCloud>> clouds) {
  return NearestPoints(std::make_unique<Impl>(std::move(clouds)));
}
NearestPoints::NearestPoints(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
NearestPoints::~NearestPoints() = default;
NearestPoints::NearestPoints(NearestPoints&&) noexcept = default;
NearestPoints& NearestPoints::operator=(NearestPoints&&) noexcept = default;

void NearestPoints::query(const std::vector<RigidTransform>& T_world_object, std::vector<NearestNeighbors>& nearest) {
  impl_->query(T_world_object, nearest);
}

}  // namespace rigidformer
