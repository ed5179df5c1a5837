// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "euclidean_segmentation.hpp"

#include <pcl/ModelCoefficients.h>
#include <pcl/octree/octree_pointcloud_pointvector.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

// Fewest points that define a plane.
constexpr std::size_t kMinPlanePoints = 3;
// Most points among which the plane is searched, to bound the time of the search; chosen by eye.
constexpr std::size_t kMaxPlanePoints = 20000;
// Size of a voxel as a share of the cluster tolerance; chosen by eye. The tolerance is exact to about one voxel.
constexpr double kVoxelShare = 0.25;

// Lists the rows of the points that can be segmented. PCL's search trees cannot take a point that is not finite, and
// far points are so noisy that points of the ground leave its plane.
std::vector<int> usable_rows(const rigidformer::Points& points, double max_range) {
  std::vector<int> rows;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (points.row(i).allFinite() && (max_range <= 0.0 || points.row(i).norm() <= max_range)) {
      rows.push_back(static_cast<int>(i));
    }
  }
  return rows;
}

pcl::PointXYZ to_pcl(const rigidformer::Points& points, int row) {
  return {points(row, 0), points(row, 1), points(row, 2)};
}

// Takes every n-th of the rows, which are enough to find a plane.
Cloud::Ptr make_plane_cloud(const rigidformer::Points& points, const std::vector<int>& rows) {
  const Cloud::Ptr cloud(new Cloud);
  const std::size_t stride = rows.size() / kMaxPlanePoints + 1;
  for (std::size_t i = 0; i < rows.size(); i += stride) {
    cloud->push_back(to_pcl(points, rows[i]));
  }
  return cloud;
}

std::optional<Eigen::Vector4d> ground_of(const rigidformer::Points& points, const std::vector<int>& rows,
                                         const SegmentationOptions& options) {
  const Cloud::Ptr cloud = make_plane_cloud(points, rows);
  if (cloud->size() < kMinPlanePoints) {
    return std::nullopt;
  }
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setDistanceThreshold(options.plane_distance);
  segmentation.setInputCloud(cloud);
  pcl::PointIndices ground;
  pcl::ModelCoefficients plane;
  segmentation.segment(ground, plane);
  if (ground.indices.empty() ||
      static_cast<double>(ground.indices.size()) < options.min_plane_share * static_cast<double>(cloud->size())) {
    return std::nullopt;
  }
  const Eigen::Vector4d found = Eigen::Map<const Eigen::Vector4f>(plane.values.data()).cast<double>();
  return found[3] < 0.0 ? Eigen::Vector4d(-found) : found;
}

// Lists the rows of the points above the largest plane: what is below it is noise of the plane, or no object on it.
// Where the camera itself lies on the plane, as in a cloud that is told in the frame of the table, no side is above.
std::vector<int> without_ground(const rigidformer::Points& points, const std::vector<int>& rows,
                                const SegmentationOptions& options) {
  const std::optional<Eigen::Vector4d> plane = ground_of(points, rows, options);
  if (!plane) {
    return rows;
  }
  const bool has_upper_side = (*plane)[3] > options.plane_distance;
  std::vector<int> rest;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(rest), [&](int row) {
    const double height = plane->head<3>().dot(points.row(row).cast<double>()) + (*plane)[3];
    return (has_upper_side ? height : std::abs(height)) > options.plane_distance;
  });
  return rest;
}

// Lists the rows of the points in each occupied voxel. The clusters are made of voxels and not of points, because the
// time to search neighbours grows with the square of their density: a whole depth image would take seconds.
std::vector<std::vector<int>> group_by_voxel(const rigidformer::Points& points, const std::vector<int>& rows,
                                             double voxel_size) {
  const Cloud::Ptr cloud(new Cloud);
  for (const int row : rows) {
    cloud->push_back(to_pcl(points, row));
  }
  pcl::octree::OctreePointCloudPointVector<pcl::PointXYZ> octree(voxel_size);
  octree.setInputCloud(cloud);
  octree.addPointsFromInputCloud();
  std::vector<std::vector<int>> voxels;
  for (auto leaf = octree.leaf_depth_begin(); leaf != octree.leaf_depth_end(); ++leaf) {
    voxels.emplace_back();
    for (const int index : leaf.getLeafContainer().getPointIndicesVector()) {
      voxels.back().push_back(rows[static_cast<std::size_t>(index)]);
    }
  }
  return voxels;
}

Cloud::Ptr make_centre_cloud(const rigidformer::Points& points, const std::vector<std::vector<int>>& voxels) {
  const Cloud::Ptr cloud(new Cloud);
  for (const std::vector<int>& voxel : voxels) {
    Eigen::RowVector3f sum = Eigen::RowVector3f::Zero();
    for (const int row : voxel) {
      sum += points.row(row);
    }
    const Eigen::RowVector3f centre = sum / static_cast<float>(voxel.size());
    cloud->push_back({centre.x(), centre.y(), centre.z()});
  }
  return cloud;
}

}  // namespace

std::optional<Eigen::Vector4d> find_ground(const rigidformer::Points& points, const SegmentationOptions& options) {
  return ground_of(points, usable_rows(points, options.max_range), options);
}

std::vector<std::vector<int>> find_objects(const rigidformer::Points& points, const SegmentationOptions& options) {
  const std::vector<int> rows = without_ground(points, usable_rows(points, options.max_range), options);
  if (rows.empty()) {
    return {};
  }
  const auto voxels = group_by_voxel(points, rows, kVoxelShare * options.cluster_tolerance);
  const Cloud::Ptr centres = make_centre_cloud(points, voxels);
  const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  tree->setInputCloud(centres);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(options.cluster_tolerance);
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(centres);
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  std::vector<std::vector<int>> objects;
  for (const pcl::PointIndices& cluster : clusters) {
    std::vector<int> object;
    for (const int index : cluster.indices) {
      const std::vector<int>& voxel = voxels[static_cast<std::size_t>(index)];
      object.insert(object.end(), voxel.begin(), voxel.end());
    }
    if (static_cast<int>(object.size()) >= options.min_cluster_points) {
      objects.push_back(std::move(object));
    }
  }
  return objects;
}
