// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// This is a worked example of a segmentation. It reads the unlabelled clouds of a depth camera on the topic `points`
// and publishes them with a label per object on the topic `cloud`, as the prediction node wants them. Label 0 means
// ground or unknown. The private parameters are the members of SegmentationOptions and SegmentationParameters; ill or
// unknown ones end the program. Objects that touch become one.
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <cstdio>
#include <exception>

#include "rigidformer/geometry/point_rows.hpp"
#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "segmentation_parameters.hpp"
#include "stable_labels.hpp"

namespace {

using rigidformer_ros::Points;
using sensor_msgs::PointField;

// Most points of a cloud: the default of the node's parameter input/max_cloud_points.
constexpr std::uint64_t kMaxPoints = 4000000;
constexpr double kSlow_s = 0.2;  // a camera sends several clouds in this time

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
  SegmentCloud(ros::NodeHandle& node, const SegmentationParameters& parameters)
      : options_(parameters.options),
        labels_(parameters.max_match_distance, parameters.max_missed_frames),
        publisher_(node.advertise<sensor_msgs::PointCloud2>("cloud", 2)),
        subscriber_(node.subscribe("points", 1, &SegmentCloud::on_cloud, this)) {}

 private:
  // All exceptions end here: one that leaves a subscriber callback would end the node.
  void on_cloud(const sensor_msgs::PointCloud2& message) {
    try {
      const ros::WallTime begin = ros::WallTime::now();
      publisher_.publish(segment(message));
      warn_if_slow((ros::WallTime::now() - begin).toSec(), message);
    } catch (const std::exception& error) {
      ROS_WARN_THROTTLE(5.0, "cloud not segmented: %s", error.what());
    }
  }

  static void warn_if_slow(double duration_s, const sensor_msgs::PointCloud2& message) {
    if (duration_s < kSlow_s) return;
    ROS_WARN_THROTTLE(10.0,
                      "segmenting a cloud of %u points took %.2f s, clouds that come meanwhile are dropped: lower "
                      "max_range, raise cluster_tolerance, or thin and crop the clouds before",
                      message.width * message.height, duration_s);
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
  try {
    ros::init(argc, argv, "segment_cloud");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "segment_cloud: %s (ROS keeps its log there: set ROS_LOG_DIR to another folder)\n",
                 error.what());
    return 1;
  }
  // Beyond the try block: the end of the last handle shuts ROS down, and with it what would print the message below.
  ros::NodeHandle node, private_node("~");
  try {
    XmlRpc::XmlRpcValue tree;
    private_node.getParam("", tree);
    SegmentCloud segment_cloud(node, read_segmentation_parameters(tree));
    ros::spin();
    return 0;
  } catch (const std::exception& error) {
    ROS_FATAL("segment_cloud: %s", error.what());
    return 1;
  }
}
