// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/depth_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace rigidformer {
namespace {

constexpr double kNearest_m = 1e-3;           // [m] nearer parts are not seen; chosen by eye
constexpr double kSurfaceTolerance_px = 3.0;  // depth that a slanted surface gains within a pixel or two; by eye

struct PixelBox {
  int first_column, last_column, first_row, last_row;
};

/// Pixels whose middles may lie inside the triangle's image; all pixels when a corner is beside or behind the camera.
PixelBox pixel_box(const CameraIntrinsics& camera, const Eigen::Matrix3d& corners) {
  if (corners.row(2).minCoeff() < kNearest_m) return {0, camera.width - 1, 0, camera.height - 1};
  const double f = camera.focal_length_px();
  const Eigen::RowVector3d columns =
      (f * corners.row(0).array() / corners.row(2).array() + 0.5 * camera.width - 0.5).matrix();
  const Eigen::RowVector3d rows =
      (f * corners.row(1).array() / corners.row(2).array() + 0.5 * camera.height - 0.5).matrix();
  const auto bound = [](double value, int size) {
    return static_cast<int>(std::clamp(value, -1.0, static_cast<double>(size)));
  };
  return {std::max(0, bound(std::ceil(columns.minCoeff()), camera.width)),
          std::min(camera.width - 1, bound(std::floor(columns.maxCoeff()), camera.width)),
          std::max(0, bound(std::ceil(rows.minCoeff()), camera.height)),
          std::min(camera.height - 1, bound(std::floor(rows.maxCoeff()), camera.height))};
}

/// Draws one triangle whose corners are the columns of `corners` [m]. Parts are closed, so
/// that back sides are never seen.
void draw_triangle(const Eigen::Matrix3d& corners, int body, DepthImage& image) {
  const Eigen::Vector3d a = corners.col(0);
  const Eigen::Vector3d normal = (corners.col(1) - a).cross(corners.col(2) - a);
  const double offset = normal.dot(a);
  if (offset >= 0.0 || corners.row(2).maxCoeff() < kNearest_m) return;
  // A ray passes through the triangle when it lies on the inner side of the three planes of the camera and an edge.
  Eigen::Matrix3d inward;
  for (int i = 0; i < 3; ++i) inward.row(i) = corners.col((i + 1) % 3).cross(corners.col(i));
  const PixelBox box = pixel_box(image.intrinsics, corners);
  for (int row = box.first_row; row <= box.last_row; ++row) {
    for (int column = box.first_column; column <= box.last_column; ++column) {
      const Eigen::Vector3d ray = image.intrinsics.ray(column + 0.5, row + 0.5);
      if (((inward * ray).array() < 0.0).any()) continue;
      const double depth = offset / normal.dot(ray);
      const std::size_t pixel = static_cast<std::size_t>(row) * image.intrinsics.width + column;
      if (depth >= kNearest_m && depth < image.depth_m[pixel]) {
        image.depth_m[pixel] = static_cast<float>(depth);
        image.body[pixel] = body;
      }
    }
  }
}

void draw_body(const CameraBody& body, int index, DepthImage& image) {
  for (const ConvexPart& part : body.shape->parts) {
    const Points vertices = body.T_camera_body.apply(part.vertices * static_cast<float>(body.size));
    for (Eigen::Index t = 0; t < part.triangles.rows(); ++t) {
      Eigen::Matrix3d corners;
      for (int i = 0; i < 3; ++i) {
        corners.col(i) = vertices.row(part.triangles(t, i)).transpose().cast<double>();
      }
      draw_triangle(corners, index, image);
    }
  }
}

void draw_ground(const RigidTransform& T_camera_world, double height_m, DepthImage& image) {
  const Eigen::Vector3d up = T_camera_world.rotation * Eigen::Vector3d::UnitZ();
  const double offset = up.dot(T_camera_world * Eigen::Vector3d(0.0, 0.0, height_m));
  std::size_t pixel = 0;
  for (int row = 0; row < image.intrinsics.height; ++row) {
    for (int column = 0; column < image.intrinsics.width; ++column, ++pixel) {
      const double depth = offset / up.dot(image.intrinsics.ray(column + 0.5, row + 0.5));
      if (depth >= kNearest_m && depth < image.depth_m[pixel]) {
        image.depth_m[pixel] = static_cast<float>(depth);
        image.body[pixel] = DepthImage::kBackground;
      }
    }
  }
}

}  // namespace

double CameraIntrinsics::focal_length_px() const { return 0.5 * width / std::tan(0.5 * horizontal_fov_rad); }

Eigen::Vector3d CameraIntrinsics::ray(double column, double row) const {
  const double f = focal_length_px();
  return {(column - 0.5 * width) / f, (row - 0.5 * height) / f, 1.0};
}

void CameraIntrinsics::validate() const {
  if (width < 1 || height < 1 || width > 8192 || height > 8192) {
    throw std::invalid_argument("width x height = " + std::to_string(width) + " x " + std::to_string(height) +
                                ", each must be in [1, 8192]");
  }
  if (!(horizontal_fov_rad > 0.0 && horizontal_fov_rad < 3.0)) {
    throw std::invalid_argument("horizontal_fov_rad = " + std::to_string(horizontal_fov_rad) + " must be in (0, 3)");
  }
}

DepthImage render_depth(const CameraIntrinsics& intrinsics, const std::vector<CameraBody>& bodies,
                        const RigidTransform& T_camera_world, const std::optional<double>& ground_height_m) {
  const std::size_t count = static_cast<std::size_t>(intrinsics.width) * intrinsics.height;
  DepthImage image{intrinsics, std::vector<float>(count, std::numeric_limits<float>::infinity()),
                   std::vector<int>(count, DepthImage::kBackground)};
  for (std::size_t i = 0; i < bodies.size(); ++i) draw_body(bodies[i], static_cast<int>(i), image);
  if (ground_height_m) draw_ground(T_camera_world, *ground_height_m, image);
  return image;
}

double visible_fraction(const DepthImage& image, const CameraBody& body, int index, const SurfaceSamples& surface) {
  const CameraIntrinsics& camera = image.intrinsics;
  const double f = camera.focal_length_px();
  const Points points = body.T_camera_body.apply(surface.points * static_cast<float>(body.size));
  const Points normals = RigidTransform{body.T_camera_body.rotation, Eigen::Vector3d::Zero()}.apply(surface.normals);
  int visible = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d p = points.row(i).transpose().cast<double>();
    if (p.z() < kNearest_m || normals.row(i).dot(points.row(i)) >= 0.0F) continue;
    const double column = f * p.x() / p.z() + 0.5 * camera.width;
    const double row = f * p.y() / p.z() + 0.5 * camera.height;
    if (column < 0.0 || row < 0.0 || column >= camera.width || row >= camera.height) continue;
    const std::size_t pixel = static_cast<std::size_t>(row) * camera.width + static_cast<std::size_t>(column);
    const double tolerance_m = kSurfaceTolerance_px * p.z() / f;
    const bool hidden = image.depth_m[pixel] < p.z() - tolerance_m;
    const bool other = image.body[pixel] != index && image.body[pixel] != DepthImage::kBackground;
    // At the rim of a body, the pixel may already show what lies behind it.
    visible += hidden || (other && image.depth_m[pixel] < p.z()) ? 0 : 1;
  }
  return points.rows() == 0 ? 0.0 : static_cast<double>(visible) / static_cast<double>(points.rows());
}

}  // namespace rigidformer
