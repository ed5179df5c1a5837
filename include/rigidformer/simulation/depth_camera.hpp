// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "rigidformer/simulation/depth_image.hpp"

namespace rigidformer {

/// A depth camera with a segmentation behind it, both as imperfect as real ones. The values were chosen by eye.
struct DepthCameraOptions {
  CameraIntrinsics intrinsics;
  double max_range_m = 30.0;     ///< [m] farther surfaces give no point
  double depth_noise_m = 0.003;  ///< [m] standard deviation along the optical axis
  double pixel_noise_px = 0.1;   ///< [px] standard deviation of a point's position in the image, per axis
  double dropout = 0.02;         ///< Share of the pixels that give no point
  double mislabelled = 0.2;      ///< Share of the pixels at a border between labels that get the label from across it
  std::uint64_t seed = 1;

  /// Throws std::invalid_argument naming field and value.
  void validate() const;
};

/// The points of one frame, in the order of their pixels.
struct CameraFrame {
  Points points_camera;    ///< [N, 3] m, in the optical frame
  std::vector<int> body;   ///< [N] body that the segmentation sees: its index, or DepthImage::kBackground
  std::vector<int> pixel;  ///< [N] number of the pixel in the image, row by row
};

/// Gives what the camera makes of an image. The same image, options and frame number give the same points. Throws
/// std::invalid_argument for invalid options.
CameraFrame measure(const DepthImage& image, const DepthCameraOptions& options, std::uint64_t frame_number);

/// Pose T_world_camera of the optical frame of a camera at `position` that looks at `target`, with its image upright
/// when z points up in world. It is not defined for a view straight up or down.
RigidTransform look_at(const Eigen::Vector3d& position, const Eigen::Vector3d& target);

}  // namespace rigidformer
