// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "rigidformer/tracking/options.hpp"
#include "rigidformer/tracking/point_tree.hpp"
#include "rigidformer/tracking/surface_cloud.hpp"

namespace rigidformer {

/// The known surface of an object: points in the object frame, about one voxel apart on each face, with normals where
/// the surface is flat enough to have one. It grows as new sides are seen, and its number of points is bounded.
/// docs/tracking.md says how ("How the reference cloud grows").
class ReferenceCloud {
 public:
  /// Begins with one cloud in the object frame, at least one point. Points far from all others are left out.
  ReferenceCloud(const SurfaceCloud& cloud_object, const CorrespondenceOptions& parameters);

  /// Takes in another cloud of the object. Known surface is averaged over the first few clouds. New surface is accepted
  /// where as many points show it as lie on a surface and where a chain of such places leads to the known surface.
  void grow(const SurfaceCloud& cloud_object);

  /// Row of a reference point near `point_object`: the nearest one on the same face as `normal_object` (zero = any
  /// face), or the nearest of all where that face is not known there.
  int nearest(const Eigen::Vector3f& point_object, const Eigen::Vector3f& normal_object) const;

  const Points& points() const { return tree_.points(); }  ///< [N, 3] m, object frame
  const Points& normals() const { return normals_; }       ///< [N, 3] unit, sign arbitrary; zero = no normal
  /// Outward direction at a reference point where its face ends; zero elsewhere. Must not be
  /// called by several threads at once.
  const Eigen::Vector3f& border(int row) const;
  /// Points that were averaged into the reference point of a row: some of those seen there.
  const std::vector<Eigen::Vector3f>& seen(int row) const { return samples_[static_cast<std::size_t>(row)].points; }
  double size_m() const { return size_m_; }              ///< Diameter of the known surface
  double voxel_size_m() const { return voxel_size_m_; }  ///< Spacing of the reference points

 private:
  using VoxelKey = std::array<int, 3>;
  /// Mean of the points seen at one place of one face.
  struct Sample {
    std::vector<Eigen::Vector3f> points;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal_sum = Eigen::Vector3f::Zero();

    void add(const Eigen::Vector3f& point, const Eigen::Vector3f& normal);
    Eigen::Vector3f mean() const { return sum / static_cast<float>(points.size()); }
    Eigen::Vector3f normal() const;
  };
  /// A place where new surface may lie.
  struct Candidate {
    Sample sample;
    int num_points = 0;  ///< Points seen there, with those that were averaged
    int last_cloud = 0;  ///< Number of the newest cloud that showed the place
  };
  using Candidates = std::multimap<VoxelKey, Candidate>;  ///< One entry per voxel and face

  VoxelKey key_of(const Eigen::Vector3f& point) const;
  std::vector<Sample> thin(const std::vector<Sample>& samples) const;
  void take_in(const Eigen::Vector3f& point, const Eigen::Vector3f& normal);
  void remember(const Eigen::Vector3f& point, const Eigen::Vector3f& normal);
  template <class Visit>
  void visit_candidates(const VoxelKey& centre, int reach, const Visit& visit) const;
  std::set<VoxelKey> supported_candidates(double min_points) const;
  std::vector<VoxelKey> connected_candidates(double min_points) const;
  void accept_candidates(double min_points);
  void rebuild();

  CorrespondenceOptions parameters_;
  double size_m_ = 0.0;
  double voxel_size_m_ = 0.0;
  int num_clouds_ = 1;
  int num_averaged_ = 0;         ///< Points averaged since the last rebuild
  std::vector<Sample> samples_;  ///< One sample per reference point
  Candidates candidates_;
  PointTree tree_;
  Points normals_;
  mutable std::vector<std::optional<Eigen::Vector3f>> borders_;  ///< Filled on demand: few rows are asked for
};

}  // namespace rigidformer
