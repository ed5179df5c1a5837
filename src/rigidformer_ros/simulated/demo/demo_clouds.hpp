// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"

namespace rigidformer_ros::demo {

/// Makes the cloud of one object with the fields x y z [m].
sensor_msgs::PointCloud2 make_object_cloud(const rigidformer::Points& points, const std_msgs::Header& header);

/// Makes one cloud of all objects with the fields x y z [m] and label, which counts the objects from 1.
sensor_msgs::PointCloud2 make_labelled_cloud(const std::vector<rigidformer::Points>& objects,
                                             const std_msgs::Header& header);

}  // namespace rigidformer_ros::demo
