// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/demo/demo_clouds.hpp"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>

namespace rigidformer_ros::demo {

sensor_msgs::PointCloud2 make_object_cloud(const rigidformer::Points& points, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  cloud.is_dense = true;
  modifier.resize(points.rows());
  sensor_msgs::PointCloud2Iterator<float> xyz(cloud, "x");
  for (Eigen::Index i = 0; i < points.rows(); ++i, ++xyz) {
    std::copy_n(points.row(i).data(), 3, &*xyz);
  }
  return cloud;
}

sensor_msgs::PointCloud2 make_labelled_cloud(const std::vector<rigidformer::Points>& objects,
                                             const std_msgs::Header& header) {
  std::size_t num_points = 0;
  for (const auto& points : objects) {
    num_points += points.rows();
  }
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  using Field = sensor_msgs::PointField;
  modifier.setPointCloud2Fields(4, "x", 1, Field::FLOAT32, "y", 1, Field::FLOAT32, "z", 1, Field::FLOAT32, "label", 1,
                                Field::UINT32);
  cloud.is_dense = true;
  modifier.resize(num_points);
  sensor_msgs::PointCloud2Iterator<float> xyz(cloud, "x");
  sensor_msgs::PointCloud2Iterator<std::uint32_t> label(cloud, "label");
  for (std::size_t object = 0; object < objects.size(); ++object) {
    for (Eigen::Index i = 0; i < objects[object].rows(); ++i, ++xyz, ++label) {
      std::copy_n(objects[object].row(i).data(), 3, &*xyz);
      *label = static_cast<std::uint32_t>(object + 1);
    }
  }
  return cloud;
}

}  // namespace rigidformer_ros::demo
