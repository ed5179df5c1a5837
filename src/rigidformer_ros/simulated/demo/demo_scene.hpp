// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigidformer/scene/recording.hpp"

namespace rigidformer_ros::demo {

/// What scene to simulate.
struct DemoSceneOptions {
  std::string set = "movi_b";  ///< One of rigidformer::scene_set_names()
  std::uint64_t seed = 1;
  std::uint64_t index = 0;      ///< Number of the scene among those of the seed
  int num_frames = 720;         ///< Frames to simulate, 240 per second
  int points_per_object = 256;  ///< Points on the whole surface of each object; 0 = the corners of its mesh
};

/// A simulated scene with ground truth, seen as one cloud per object: the same points in the same order in every frame.
class DemoScene {
 public:
  /// Simulates the scene. Throws std::invalid_argument for options that make no scene.
  explicit DemoScene(const DemoSceneOptions& options);

  int num_objects() const { return static_cast<int>(clouds_.size()); }
  int num_frames() const { return recording_.num_frames; }
  double frame_rate_hz() const { return recording_.frame_rate_hz; }

  /// The id of an object: object_0, object_1, ... They are the same in every scene, as from a tracker that numbers what
  /// it sees.
  static std::string object_id(int object);

  /// The points [N, 3] m of `object` at `frame`, in the world frame.
  rigidformer::Points cloud_world(int object, int frame) const;

  /// The true pose of the cloud of `object` at `frame`. Its origin is the centroid of the cloud, its axes are those of
  /// the simulated body.
  rigidformer::RigidTransform T_world_cloud(int object, int frame) const;

 private:
  rigidformer::SceneRecording recording_;
  std::vector<rigidformer::Points> clouds_;         // Each object's points about their centroid, along the body's axes
  std::vector<Eigen::Vector3d> centroids_in_body_;  // Each object's centroid in the body frame [m]
};

}  // namespace rigidformer_ros::demo
