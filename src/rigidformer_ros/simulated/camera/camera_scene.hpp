// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigidformer/data/scene_archive.hpp"
#include "rigidformer/simulation/depth_camera.hpp"
#include "rigidformer_ros/simulated/camera/camera_options.hpp"

namespace rigidformer_ros::camera {

/// One frame of the camera.
struct CameraView {
  rigidformer::DepthImage image;                ///< The image without noise
  rigidformer::CameraFrame frame;               ///< The points that the camera measures in that image
  std::vector<rigidformer::CameraBody> bodies;  ///< Shape, size and true pose of each object

  /// The points [N, 3] m that are labelled as `object`, in the camera frame.
  rigidformer::Points points_of(int object) const;
};

/// A moving scene with ground truth in front of a depth camera that stands still.
class CameraScene {
 public:
  /// Makes scene `index` of the options. The scene is simulated or read from the file of the options; after the last
  /// scene of the file comes its first one again. Throws std::invalid_argument or std::runtime_error naming the option
  /// or the file.
  CameraScene(const CameraOptions& options, std::uint64_t index);

  int num_objects() const { return static_cast<int>(recording().objects.size()); }
  int num_frames() const { return num_frames_; }
  double time_s(int frame) const { return frame / options_.frame_rate; }

  /// The id of an object: obj_1, obj_2, ..., as the node calls the labels 1, 2, ...
  static std::string object_id(int object) { return "obj_" + std::to_string(object + 1); }

  const rigidformer::RigidTransform& T_world_camera() const { return T_world_camera_; }

  /// The pose of the body frame (origin = centre of mass) at `time_s` from the start of the scene. Before the start and
  /// after the end, the object rests at its first and last pose.
  rigidformer::RigidTransform T_world_object(int object, double time_s) const;

  const std::string& shape_name(int object) const { return recording().objects.at(object).shape; }

  /// Renders and measures a frame. This is done anew in every call, but the same frame always gives the same points.
  CameraView view(int frame) const;

  /// The share of the surface of `object` that is seen, in [0, 1].
  double visible_fraction(const CameraView& view, int object) const;

  /// Evenly spread points of the whole surface in the body frame. They are the same in every call.
  rigidformer::Points surface_points(int object) const;

 private:
  const rigidformer::SceneRecording& recording() const { return archive_.scenes.front(); }
  const rigidformer::Shape& shape(int object) const;

  CameraOptions options_;
  rigidformer::SceneArchive archive_;                  ///< The shapes and this one scene
  std::vector<rigidformer::SurfaceSamples> surfaces_;  ///< Surface points of each object's shape at size 1
  rigidformer::RigidTransform T_world_camera_;
  double recorded_rate_hz_;  ///< Frames of the recording per second, at the scale of the options
  int num_frames_;
  std::uint64_t index_;
};

}  // namespace rigidformer_ros::camera
