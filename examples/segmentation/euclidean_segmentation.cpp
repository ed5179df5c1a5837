// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "euclidean_segmentation.hpp"

#include <pcl/ModelCoefficients.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/sac_segmentation.h>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr int kMinPlanePoints = 3;

// PCL's search trees must not meet a point that is not finite. The noise of far points leaves the plane of the ground.
std::vector<int> usable_rows(const rigidformer::Points& points, double max_range) {
  std::vector<int> rows;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (points.row(i).allFinite() && (max_range <= 0.0 || points.row(i).norm() <= max_range)) {
      rows.push_back(static_cast<int>(i));
    }
  }
  return rows;
}

Cloud::Ptr make_cloud(const rigidformer::Points& points, const std::vector<int>& rows) {
  const Cloud::Ptr cloud(new Cloud);
  for (const int row : rows) {
    cloud->push_back({points(row, 0), points(row, 1), points(row, 2)});
  }
  return cloud;
}

// The rows that do not lie on the largest plane.
std::vector<int> without_ground(const rigidformer::Points& points, const std::vector<int>& rows,
                                const SegmentationOptions& options) {
  if (rows.size() < kMinPlanePoints) {
    return rows;
  }
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setDistanceThreshold(options.plane_distance);
  segmentation.setInputCloud(make_cloud(points, rows));
  pcl::PointIndices ground;
  pcl::ModelCoefficients plane;
  segmentation.segment(ground, plane);
  if (static_cast<double>(ground.indices.size()) < options.min_plane_share * static_cast<double>(rows.size())) {
    return rows;
  }
  std::vector<bool> is_ground(rows.size(), false);
  for (const int index : ground.indices) {
    is_ground[static_cast<std::size_t>(index)] = true;
  }
  std::vector<int> rest;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!is_ground[i]) {
      rest.push_back(rows[i]);
    }
  }
  return rest;
}

}  // namespace

std::vector<std::vector<int>> find_objects(const rigidformer::Points& points, const SegmentationOptions& options) {
  const std::vector<int> rows = without_ground(points, usable_rows(points, options.max_range), options);
  if (rows.empty()) {
    return {};
  }
  const Cloud::Ptr cloud = make_cloud(points, rows);
  const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  tree->setInputCloud(cloud);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(options.cluster_tolerance);
  extraction.setMinClusterSize(options.min_cluster_points);
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(cloud);
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  std::vector<std::vector<int>> objects;
  for (const pcl::PointIndices& cluster : clusters) {
    objects.emplace_back();
    for (const int index : cluster.indices) {
      objects.back().push_back(rows[static_cast<std::size_t>(index)]);
    }
  }
  return objects;
}
