// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/point_tree.hpp"

#include <algorithm>
#include <nanoflann.hpp>
#include <utility>

namespace rigidformer {

namespace {

constexpr int kSpacingNeighbors = 3;  // neighbours; the spacing is the distance of the last one; chosen by eye

}  // namespace

class PointTree::Index {
 public:
  explicit Index(Points points) : points_(std::move(points)), tree_(3, *this, {kLeafSize}) {}
  Index(const Index&) = delete;
  Index& operator=(const Index&) = delete;

  const Points& points() const { return points_; }

  void find(const Eigen::Vector3f& point, int count, int* rows, float* squared_distances) const {
    tree_.knnSearch(point.data(), static_cast<std::size_t>(count), rows, squared_distances);
  }

  // nanoflann asks these questions of a data set.
  std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(points_.rows()); }
  float kdtree_get_pt(int row, std::size_t axis) const { return points_(row, static_cast<Eigen::Index>(axis)); }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

 private:
  static constexpr std::size_t kLeafSize = 12;  // points; changes the speed only; chosen by eye
  using Distance = nanoflann::L2_Simple_Adaptor<float, Index, float, int>;

  Points points_;
  nanoflann::KDTreeSingleIndexAdaptor<Distance, Index, 3, int> tree_;
};

PointTree::PointTree(Points points) : index_(std::make_unique<Index>(std::move(points))) {}
PointTree::~PointTree() = default;
PointTree::PointTree(PointTree&&) noexcept = default;
PointTree& PointTree::operator=(PointTree&&) noexcept = default;

const Points& PointTree::points() const { return index_->points(); }

int PointTree::nearest(const Eigen::Vector3f& point) const {
  int row = 0;
  float squared_distance = 0.0F;
  index_->find(point, 1, &row, &squared_distance);
  return row;
}

void PointTree::nearest(const Eigen::Vector3f& point, int count, std::vector<int>& rows) const {
  rows.resize(static_cast<std::size_t>(std::min<Eigen::Index>(count, points().rows())));
  std::vector<float> squared_distances(rows.size());
  index_->find(point, static_cast<int>(rows.size()), rows.data(), squared_distances.data());
}

int PointTree::find(const Eigen::Vector3f& point, int* rows, float* squared_distances, int count) const {
  const auto found = static_cast<int>(std::min<Eigen::Index>(count, points().rows()));
  index_->find(point, found, rows, squared_distances);
  return found;
}

std::vector<double> neighbor_spacing(const PointTree& tree) {
  const Points& points = tree.points();
  std::vector<double> spacing;
  std::vector<int> rows;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    tree.nearest(points.row(i).transpose(), kSpacingNeighbors + 1, rows);
    spacing.push_back((points.row(rows.back()) - points.row(i)).norm());
  }
  return spacing;
}

}  // namespace rigidformer
