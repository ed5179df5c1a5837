// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/scene/object.hpp"

namespace rigidformer {

/// Motion of one object in a recorded or simulated scene: the ground truth.
struct RecordedObject {
  std::string shape;  ///< Name of the shape in the library (Kubric: asset_id)
  double size = 1.0;  ///< Uniform scale of the shape
  BodyProperties properties;
  bool is_static = false;                      ///< Never moves, whatever hits it (table, shelf, wall)
  bool is_driven = false;                      ///< Goes its own way, whatever it pushes (finger, palm); not static
  std::vector<RigidTransform> T_world_object;  ///< One pose per frame; the origin is the centre of mass
  std::vector<Eigen::Vector3d> velocities;     ///< Velocity of the centre of mass [m/s], one per frame; may be empty
  std::vector<Eigen::Vector3d> angular_velocities;  ///< Angular velocity in world [rad/s], one per frame; may be empty
  /// [m] Given by a file instead of the size, which follows from it once the mesh is known. Empty in loaded scenes.
  std::optional<double> largest_extent_m;

  /// Whether nobody has to predict the object.
  bool is_given() const { return is_static || is_driven; }
};

/// Whether gravity points along -z, within the two degrees by which a floor may be tilted, or vanishes. The network
/// and the floor z = 0 know no other direction, and count its vertical component alone.
bool points_down(const Eigen::Vector3d& gravity);

/// A scene over time at a fixed frame rate.
struct SceneRecording {
  std::string name;  ///< Folder or archive index, for messages
  std::uint64_t seed = 0;
  double frame_rate_hz = 240.0;
  int num_frames = 0;
  Eigen::Vector3d gravity{0.0, 0.0, -10.0};  ///< [m/s^2] as in the MOVi scenes; a tilted floor turns it
  GroundProperties ground{0.3, 0.5};         ///< As in the MOVi scenes
  std::vector<RecordedObject> objects;
  /// Command that counts from each frame on, one per frame and all of one width; empty where nothing is commanded.
  std::vector<std::vector<double>> control;
  int control_directions = 0;  ///< So many horizontal vectors (x, y) end the command: they turn with the scene
};

/// The commands of `num_steps` steps of `step` frames each, the first from `frame` on; the last recorded one goes on.
/// Empty where nothing is commanded.
std::vector<std::vector<double>> commands_of_steps(const SceneRecording& scene, int frame, int step, int num_steps);

}  // namespace rigidformer
