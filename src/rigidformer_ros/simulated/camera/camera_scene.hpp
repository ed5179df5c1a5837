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
  rigidformer::DepthImage image;
  rigidformer::CameraFrame frame;
  std::vector<rigidformer::CameraBody> bodies;

  /// The points that are labelled as `object` [N, 3] m, camera frame.
  rigidformer::Points points_of(int object) const;
};

/// A moving scene with ground truth in front of a depth camera that stands still.
class CameraScene {
 public:
  /// Scene `index` of the options: simulated, or read from their file, which is shown from its start again after its
  /// last scene. Throws std::invalid_argument or std::runtime_error naming option or file.
  CameraScene(const CameraOptions& options, std::uint64_t index);

  int num_objects() const { return static_cast<int>(recording().objects.size()); }
  int num_frames() const { return num_frames_; }
  double time_s(int frame) const { return frame / options_.frame_rate; }

  /// obj_1, obj_2, ...: the ids that the node gives to the labels 1, 2, ...
  static std::string object_id(int object) { return "obj_" + std::to_string(object + 1); }

  const rigidformer::RigidTransform& T_world_camera() const { return T_world_camera_; }

  /// Pose of the body frame (origin = centre of mass) at `time_s` from the start of the scene, held outside it.
  rigidformer::RigidTransform T_world_object(int object, double time_s) const;

  const std::string& shape_name(int object) const { return recording().objects.at(object).shape; }

  /// Rendered and measured anew in every call; the same frame gives the same points.
  CameraView view(int frame) const;

  /// Share of the surface of `object` that is seen, in [0, 1].
  double visible_fraction(const CameraView& view, int object) const;

  /// Evenly spread points of the whole surface, body frame: the same in every call.
  rigidformer::Points surface_points(int object) const;

 private:
  const rigidformer::SceneRecording& recording() const { return archive_.scenes.front(); }
  const rigidformer::Shape& shape(int object) const;

  CameraOptions options_;
  rigidformer::SceneArchive archive_;                  ///< One scene
  std::vector<rigidformer::SurfaceSamples> surfaces_;  ///< Per object, at size 1
  rigidformer::RigidTransform T_world_camera_;
  double recorded_rate_hz_;  ///< At the scale of the options
  int num_frames_;
  std::uint64_t index_;
};

}  // namespace rigidformer_ros::camera
