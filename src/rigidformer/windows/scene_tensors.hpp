// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <vector>

#include "rigidformer/data/scene_archive.hpp"
#include "rigidformer/windows/options.hpp"

namespace rigidformer {

using torch::Tensor;

/// All scenes of several archives as padded tensors on one device. S scenes, F frames, K objects, Q shapes, P sets,
/// M points per set.
struct SceneTensors {
  Tensor poses;  ///< [S, F, K, 7] x y z qx qy qz qw, T_world_object, origin = centre of mass; the last one is repeated
  Tensor object_mask;          ///< [S, K] bool
  Tensor shape;                ///< [S, K] int64 into Q
  Tensor size;                 ///< [S, K] scale of the shape
  Tensor properties;           ///< [S, K, 3] mass, friction, restitution
  Tensor gravity;              ///< [S] vertical component [m/s^2]
  Tensor shape_points;         ///< [Q, P, M, 3] at size 1
  Tensor shape_normals;        ///< [Q, P, M, 3] of the mesh, for what a camera sees
  Tensor estimated_normals;    ///< [Q, P, M, 3] what estimate_normals() makes of the points, as at prediction
  Tensor shape_point_count;    ///< [Q, P] int64
  Tensor frame_count;          ///< [S] int64, at most F: frames after it do not exist
  Tensor dynamic_mask;         ///< [S, K] bool, objects that move
  Tensor properties_known;     ///< [S, K, 3] 1 where the recording says them; others hold the means of the MOVi sets
  Tensor frame_rate;           ///< [S] frames per second
  Tensor ground_material;      ///< [S, 2] friction, restitution of the ground; 0 where unknown
  Tensor ground_known;         ///< [S, 2] 1 where the recording says them
  Tensor control = {};         ///< [S, F, C] command that counts from each frame on; undefined = nothing is commanded
  int control_directions = 0;  ///< So many horizontal vectors (x, y) end the command

  std::int64_t num_scenes() const { return poses.size(0); }
  std::int64_t num_frames() const { return poses.size(1); }
  std::int64_t max_objects() const { return poses.size(2); }

  /// Number of objects of every scene.
  std::vector<std::int64_t> object_counts() const;

  /// Number of frames of every scene.
  std::vector<std::int64_t> frame_counts() const;

  /// Frames per second of every scene.
  std::vector<double> frame_rates() const;

  SceneTensors to(const torch::Device& device) const;
};

/// Rotation matrices [..., 3, 3] from unit quaternions x y z w [..., 4].
Tensor rotation_matrix(const Tensor& quaternion);

/// Number of frames of a scene in `frames` frames of 1/240 s: at least 1, else rounded down, so that no step becomes
/// longer than a network is told to expect.
int frames_at_rate(int frames, double frame_rate_hz);

/// Throws std::invalid_argument when there is no scene, or when one has commands of another width than the first.
SceneTensors make_scene_tensors(const std::vector<SceneArchive>& archives, const PointSetOptions& options);

}  // namespace rigidformer
