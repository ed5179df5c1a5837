// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "rigidformer/geometry/point_rows.hpp"
#include "still_scene.hpp"

namespace {

using rigidformer::Points;

const pcl::PCLPointField* field_of(const pcl::PCLPointCloud2& cloud, const std::string& name) {
  for (const pcl::PCLPointField& field : cloud.fields) {
    if (field.name == name && pcl::getFieldSize(field.datatype) == 4) return &field;
  }
  return nullptr;
}

template <typename Number>
Number value_at(const pcl::PCLPointCloud2& cloud, const pcl::PCLPointField& field, std::size_t point) {
  Number number;
  std::memcpy(&number, cloud.data.data() + point * cloud.point_step + field.offset, sizeof(number));
  return number;
}

bool has_header(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line) && line.size() < 1000) {
    if (line.rfind("POINTS", 0) == 0) return true;
    if (line.rfind("DATA", 0) == 0) return false;
  }
  return false;
}

/// World: the plane is z = 0, and the camera stands above the origin.
rigidformer::RigidTransform stand_on(const Eigen::Vector4d& plane_camera) {
  const Eigen::Quaterniond R =
      Eigen::Quaterniond::FromTwoVectors(plane_camera.head<3>(), Eigen::Vector3d::UnitZ()).normalized();
  return {R, Eigen::Vector3d(0.0, 0.0, plane_camera[3])};
}

}  // namespace

StillScene read_still_scene(const std::string& file, const SegmentationOptions& options) {
  pcl::PCLPointCloud2 cloud;
  // PCL's reader crashes on files that have no header of its own.
  if (!has_header(file)) throw std::runtime_error(file + ": is not a PCD file");
  if (pcl::PCDReader().read(file, cloud) != 0) throw std::runtime_error(file + ": cannot be read as a PCD file");
  const pcl::PCLPointField* xyz[] = {field_of(cloud, "x"), field_of(cloud, "y"), field_of(cloud, "z")};
  const pcl::PCLPointField* label = field_of(cloud, "label");
  if (!xyz[0] || !xyz[1] || !xyz[2]) throw std::runtime_error(file + ": has no fields x, y, z of 4 bytes");
  StillScene scene;
  scene.points_camera.resize(static_cast<Eigen::Index>(cloud.width * cloud.height), 3);
  for (std::size_t i = 0; i < static_cast<std::size_t>(scene.points_camera.rows()); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      scene.points_camera(static_cast<Eigen::Index>(i), axis) = value_at<float>(cloud, *xyz[axis], i);
    }
    if (label != nullptr) scene.labels.push_back(value_at<std::uint32_t>(cloud, *label, i));
  }
  const auto plane = find_ground(scene.points_camera, options);
  if (!plane) throw std::runtime_error(file + ": shows no table, the largest plane is too small");
  scene.T_world_camera = stand_on(*plane);
  return scene;
}
