// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer_ros/simulated/camera/camera_messages.hpp"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>

#include "rigidformer_ros/messages/cloud_conversion.hpp"
#include "rigidformer_ros/messages/conversions.hpp"

namespace rigidformer_ros::camera {
namespace {

using sensor_msgs::PointField;

sensor_msgs::PointCloud2 make_cloud(const rigidformer::CameraFrame& frame, bool labels) {
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  const auto count = static_cast<std::size_t>(frame.points_camera.rows());
  if (labels) {
    modifier.setPointCloud2Fields(4, "x", 1, PointField::FLOAT32, "y", 1, PointField::FLOAT32, "z", 1,
                                  PointField::FLOAT32, "label", 1, PointField::UINT32);
  } else {
    modifier.setPointCloud2Fields(3, "x", 1, PointField::FLOAT32, "y", 1, PointField::FLOAT32, "z", 1,
                                  PointField::FLOAT32);
  }
  modifier.resize(count);
  cloud.is_dense = true;
  sensor_msgs::PointCloud2Iterator<float> xyz(cloud, "x");
  for (Eigen::Index i = 0; i < frame.points_camera.rows(); ++i, ++xyz) {
    std::copy_n(frame.points_camera.row(i).data(), 3, &*xyz);
  }
  if (labels) {
    sensor_msgs::PointCloud2Iterator<std::uint32_t> label(cloud, "label");
    for (std::size_t i = 0; i < count; ++i, ++label) {
      *label = static_cast<std::uint32_t>(frame.body[i] + 1);
    }
  }
  return cloud;
}

geometry_msgs::TransformStamped to_message(const rigidformer::RigidTransform& T_parent_child) {
  geometry_msgs::TransformStamped message;
  const geometry_msgs::Pose pose = to_pose(T_parent_child);
  message.transform.translation.x = pose.position.x;
  message.transform.translation.y = pose.position.y;
  message.transform.translation.z = pose.position.z;
  message.transform.rotation = pose.orientation;
  return message;
}

}  // namespace

FrameMessages make_messages(const CameraScene& scene, int frame, const CameraOptions& options, const ros::Time& stamp) {
  const CameraView view = scene.view(frame);
  FrameMessages messages;
  messages.cloud = make_cloud(view.frame, options.labels);
  messages.cloud.header.stamp = stamp;
  messages.cloud.header.frame_id = options.camera_frame;
  messages.object_clouds.header = messages.cloud.header;
  for (int object = 0; object < scene.num_objects(); ++object) {
    const rigidformer::Points points = view.points_of(object);
    if (points.rows() == 0) {
      continue;
    }
    messages.object_clouds.ids.push_back(CameraScene::object_id(object));
    messages.object_clouds.clouds.push_back(to_cloud(points));
    messages.object_clouds.poses.push_back(to_pose(view.bodies[static_cast<std::size_t>(object)].T_camera_body));
    messages.object_frames.push_back(to_message(scene.T_world_object(object, scene.time_s(frame))));
    messages.object_frames.back().header.stamp = stamp;
    messages.object_frames.back().header.frame_id = options.fixed_frame;
    messages.object_frames.back().child_frame_id = options.pose_frame_prefix + CameraScene::object_id(object);
  }
  return messages;
}

geometry_msgs::TransformStamped camera_transform(const CameraScene& scene, const CameraOptions& options,
                                                 const ros::Time& stamp) {
  geometry_msgs::TransformStamped message = to_message(scene.T_world_camera());
  message.header.stamp = stamp;
  message.header.frame_id = options.fixed_frame;
  message.child_frame_id = options.camera_frame;
  return message;
}

SceneForecast make_truth(const CameraScene& scene, const CameraOptions& options, const ros::Time& start) {
  SceneForecast truth;
  truth.header.stamp = start;
  truth.header.frame_id = options.fixed_frame;
  truth.time_step = 1.0 / options.frame_rate;
  truth.model_id = "simulation";
  for (int frame = 0; frame < scene.num_frames(); ++frame) {
    truth.times.push_back(scene.time_s(frame));
  }
  for (int object = 0; object < scene.num_objects(); ++object) {
    ObjectForecast motion;
    motion.id = CameraScene::object_id(object);
    for (int frame = 0; frame < scene.num_frames(); ++frame) {
      motion.poses.push_back(to_pose(scene.T_world_object(object, scene.time_s(frame))));
    }
    truth.objects.push_back(motion);
  }
  return truth;
}

}  // namespace rigidformer_ros::camera
