// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <vector>

#include "rigidformer_ros/parameters.hpp"
#include "rigidformer_ros/point_tree.hpp"

namespace rigidformer_ros {

/// What is known of an object's surface: points in the object frame about one voxel apart, with normals where the
/// surface is flat enough to have one. Grows as new sides are seen; bounded in number.
class ReferenceCloud {
 public:
  /// Begins with the points of one cloud [N, 3] m, N >= 1, in the object frame. Points far from all others are left
  /// out.
  ReferenceCloud(const Points& points_object, const CorrespondenceParameters& parameters);

  /// Takes in another cloud [N, 3] m of the object. Surface already known is averaged over the first few clouds; new
  /// surface counts from the second time that it is seen, and only where it continues the known one.
  void grow(const Points& points_object);

  /// Row of the nearest reference point.
  int nearest(const Eigen::Vector3f& point_object) const { return tree_.nearest(point_object); }

  const Points& points() const { return tree_.points(); }  ///< [N, 3] m
  const Points& normals() const { return normals_; }       ///< [N, 3], sign arbitrary; zero = no normal
  double size_m() const { return size_m_; }                ///< Diameter of what is known
  double voxel_size_m() const { return voxel_size_m_; }

 private:
  using VoxelKey = std::array<int, 3>;
  /// The mean of the points seen at one place.
  struct Sample {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    int count = 0;

    void add(const Eigen::Vector3f& point);
    Eigen::Vector3f mean() const { return sum / static_cast<float>(count); }
  };
  /// A place where there may be new surface.
  struct Candidate {
    Sample sample;
    int clouds = 0;      ///< In which it was seen
    int last_cloud = 0;  ///< Number of the newest of them
  };

  VoxelKey key_of(const Eigen::Vector3f& point) const;
  std::vector<Sample> thin(const std::vector<Sample>& samples) const;
  void take_in(const Eigen::Vector3f& point);
  void accept_candidates();
  void rebuild();

  CorrespondenceParameters parameters_;
  double size_m_ = 0.0;
  double voxel_size_m_ = 0.0;
  int num_clouds_ = 1;
  int num_averaged_ = 0;         ///< Points averaged since the last rebuild
  std::vector<Sample> samples_;  ///< One per reference point
  std::map<VoxelKey, Candidate> candidates_;
  PointTree tree_;
  Points normals_;
};

}  // namespace rigidformer_ros
