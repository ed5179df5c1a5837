// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <rigidformer_ros/ObjectClouds.h>
#include <rigidformer_ros/SceneForecast.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

#include "rigidformer_ros/simulated/camera/camera_scene.hpp"

namespace rigidformer_ros::camera {

/// Topics, relative to the namespace.
inline constexpr char kCloudTopic[] = "cloud";
inline constexpr char kObjectCloudsTopic[] = "object_clouds";
inline constexpr char kTruthTopic[] = "camera/truth";

/// What a perception pipeline says about one frame.
struct FrameMessages {
  sensor_msgs::PointCloud2 cloud;  ///< x y z [m] and, if asked for, label (0 = background); camera frame
  ObjectClouds object_clouds;      ///< The objects that are seen, with their true poses; camera frame
  std::vector<geometry_msgs::TransformStamped> object_frames;  ///< True poses of the same objects in the fixed frame
};

FrameMessages make_messages(const CameraScene& scene, int frame, const CameraOptions& options, const ros::Time& stamp);

/// Pose of the camera in the fixed frame.
geometry_msgs::TransformStamped camera_transform(const CameraScene& scene, const CameraOptions& options,
                                                 const ros::Time& stamp);

/// True motion of all objects' body frames (origin = centre of mass) through the scene, one pose per frame.
SceneForecast make_truth(const CameraScene& scene, const CameraOptions& options, const ros::Time& start);

}  // namespace rigidformer_ros::camera
