// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "rigidformer/scene/shape.hpp"
#include "rigidformer/scene/surface_sampling.hpp"

namespace rigidformer {

/// A pinhole camera. Its optical frame has x to the right, y down, z forward; the optical axis meets the image centre.
/// The values were chosen by eye.
struct CameraIntrinsics {
  int width = 320;   ///< Number of columns [px]
  int height = 240;  ///< Number of rows [px]
  double horizontal_fov_rad = 1.05;

  double focal_length_px() const;
  /// Point with z = 1 on the ray through the image position (column, row) [px]; pixel (i, j) reaches from i to i + 1.
  Eigen::Vector3d ray(double column, double row) const;
  /// Throws std::invalid_argument naming field and value.
  void validate() const;
};

/// One rigid body in front of a camera. The shape must outlive it.
struct CameraBody {
  const Shape* shape = nullptr;
  double size = 1.0;
  RigidTransform T_camera_body;
};

/// The surfaces that the rays through the middle of every pixel meet first, row by row.
struct DepthImage {
  static constexpr int kBackground = -1;  ///< No body: the ground or nothing

  CameraIntrinsics intrinsics;
  std::vector<float> depth_m;  ///< Depth along the optical axis; infinity where there is nothing
  std::vector<int> body;       ///< Index of the body, or kBackground
};

/// Renders bodies and, if given, the ground plane z = ground_height_m of the world. Bodies hide each other and
/// themselves. Parts nearer than 1 mm to the camera are not seen.
DepthImage render_depth(const CameraIntrinsics& intrinsics, const std::vector<CameraBody>& bodies,
                        const RigidTransform& T_camera_world, const std::optional<double>& ground_height_m);

/// Share of the body's surface that the image shows, in [0, 1]: a convex body shows about one half at most. `surface`
/// holds samples of the body's shape at size 1. `index` is the body's number in the image.
double visible_fraction(const DepthImage& image, const CameraBody& body, int index, const SurfaceSamples& surface);

}  // namespace rigidformer
