// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// This is a worked example of a segmentation. It reads the unlabelled clouds of a depth camera on the topic `points`
// and publishes them with a label per object on the topic `cloud`, as the prediction node wants them. Label 0 means
// ground or unknown. The private parameters are the members of SegmentationOptions, max_match_distance and
// max_missed_frames. Objects that touch become one.
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <exception>

#include "euclidean_segmentation.hpp"
#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "stable_labels.hpp"

namespace {

using rigidformer_ros::Points;
using sensor_msgs::PointField;

// Most points of a cloud: the default of the node's parameter input/max_cloud_points.
constexpr std::uint64_t kMaxPoints = 4000000;

std::vector<Eigen::Vector3d> centroids_of(const Points& points, const std::vector<std::vector<int>>& objects) {
  std::vector<Eigen::Vector3d> centroids;
  for (const std::vector<int>& rows : objects) {
    centroids.push_back(rigidformer::select_rows(points, rows).cast<double>().colwise().mean().transpose());
  }
  return centroids;
}

sensor_msgs::PointCloud2 make_labelled(const Points& points, const std::vector<std::uint32_t>& labels) {
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2Fields(4, "x", 1, PointField::FLOAT32, "y", 1, PointField::FLOAT32, "z", 1,
                                PointField::FLOAT32, "label", 1, PointField::UINT32);
  modifier.resize(labels.size());
  sensor_msgs::PointCloud2Iterator<float> xyz(cloud, "x");
  sensor_msgs::PointCloud2Iterator<std::uint32_t> label(cloud, "label");
  for (std::size_t i = 0; i < labels.size(); ++i, ++xyz, ++label) {
    std::copy_n(points.row(static_cast<Eigen::Index>(i)).data(), 3, &*xyz);
    *label = labels[i];
  }
  return cloud;
}

class SegmentCloud {
 public:
  explicit SegmentCloud(ros::NodeHandle& node)
      : labels_(ros::param::param("~max_match_distance", 0.1), ros::param::param("~max_missed_frames", 5)),
        publisher_(node.advertise<sensor_msgs::PointCloud2>("cloud", 2)),
        subscriber_(node.subscribe("points", 1, &SegmentCloud::on_cloud, this)) {
    ros::param::param("~max_range", options_.max_range, options_.max_range);
    ros::param::param("~plane_distance", options_.plane_distance, options_.plane_distance);
    ros::param::param("~min_plane_share", options_.min_plane_share, options_.min_plane_share);
    ros::param::param("~cluster_tolerance", options_.cluster_tolerance, options_.cluster_tolerance);
    ros::param::param("~min_cluster_points", options_.min_cluster_points, options_.min_cluster_points);
  }

 private:
  // All exceptions end here: one that leaves a subscriber callback would end the node.
  void on_cloud(const sensor_msgs::PointCloud2& message) {
    try {
      publisher_.publish(segment(message));
    } catch (const std::exception& error) {
      ROS_WARN_THROTTLE(5.0, "cloud not segmented: %s", error.what());
    }
  }

  sensor_msgs::PointCloud2 segment(const sensor_msgs::PointCloud2& message) {
    const Points points = rigidformer_ros::read_points(message, kMaxPoints);
    const std::vector<std::vector<int>> objects = find_objects(points, options_);
    const std::vector<std::uint32_t> labels = labels_.assign(centroids_of(points, objects));
    std::vector<std::uint32_t> label_of_point(static_cast<std::size_t>(points.rows()), 0);
    for (std::size_t object = 0; object < objects.size(); ++object) {
      for (const int row : objects[object]) {
        label_of_point[static_cast<std::size_t>(row)] = labels[object];
      }
    }
    sensor_msgs::PointCloud2 cloud = make_labelled(points, label_of_point);
    cloud.header = message.header;
    return cloud;
  }

  SegmentationOptions options_;
  StableLabels labels_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "segment_cloud");
  ros::NodeHandle node;
  SegmentCloud segment_cloud(node);
  ros::spin();
  return 0;
}
