// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/depth_camera.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "rigidformer/geometry/random.hpp"

namespace rigidformer {
namespace {

/// Draws a standard normal number by the method of Box and Muller.
double draw_normal(Random& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform(0.0, 1.0)));
  return radius * std::cos(random.uniform(0.0, 2.0 * M_PI));
}

/// The labels of the four neighbours of a pixel; beyond the edge of the image the pixel's own label.
std::vector<int> neighbours(const DepthImage& image, int column, int row) {
  const int width = image.intrinsics.width;
  const auto at = [&](int c, int r) {
    const bool inside = c >= 0 && c < width && r >= 0 && r < image.intrinsics.height;
    return image.body[static_cast<std::size_t>(inside ? r * width + c : row * width + column)];
  };
  return {at(column - 1, row), at(column + 1, row), at(column, row - 1), at(column, row + 1)};
}

int segment(const DepthImage& image, int column, int row, double mislabelled, Random& random) {
  const int own = image.body[static_cast<std::size_t>(row) * image.intrinsics.width + column];
  std::vector<int> others;
  for (const int label : neighbours(image, column, row)) {
    if (label != own) others.push_back(label);
  }
  if (others.empty() || random.uniform(0.0, 1.0) >= mislabelled) return own;
  return others[static_cast<std::size_t>(random.uniform_int(0, static_cast<int>(others.size()) - 1))];
}

void require(bool accepted, const char* name, double value, const char* range) {
  if (!accepted) throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + " must be " + range);
}

}  // namespace

void DepthCameraOptions::validate() const {
  intrinsics.validate();
  require(max_range_m > 0.0, "max_range_m", max_range_m, "positive");
  require(depth_noise_m >= 0.0, "depth_noise_m", depth_noise_m, "at least 0");
  require(pixel_noise_px >= 0.0, "pixel_noise_px", pixel_noise_px, "at least 0");
  require(dropout >= 0.0 && dropout < 1.0, "dropout", dropout, "in [0, 1)");
  require(mislabelled >= 0.0 && mislabelled <= 1.0, "mislabelled", mislabelled, "in [0, 1]");
}

CameraFrame measure(const DepthImage& image, const DepthCameraOptions& options, std::uint64_t frame_number) {
  options.validate();
  Random random(options.seed, frame_number);
  CameraFrame frame;
  std::vector<Eigen::Vector3f> points;
  int pixel = -1;
  for (int row = 0; row < image.intrinsics.height; ++row) {
    for (int column = 0; column < image.intrinsics.width; ++column) {
      const double depth = image.depth_m[static_cast<std::size_t>(++pixel)];
      if (depth > options.max_range_m || random.uniform(0.0, 1.0) < options.dropout) continue;
      const double measured_column = column + 0.5 + options.pixel_noise_px * draw_normal(random);
      const double measured_row = row + 0.5 + options.pixel_noise_px * draw_normal(random);
      const double measured_depth = depth + options.depth_noise_m * draw_normal(random);
      points.push_back((measured_depth * image.intrinsics.ray(measured_column, measured_row)).cast<float>());
      frame.body.push_back(segment(image, column, row, options.mislabelled, random));
      frame.pixel.push_back(pixel);
    }
  }
  frame.points_camera.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    frame.points_camera.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  }
  return frame;
}

RigidTransform look_at(const Eigen::Vector3d& position, const Eigen::Vector3d& target) {
  const Eigen::Vector3d forward = (target - position).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Matrix3d R_world_camera;
  R_world_camera << right, forward.cross(right), forward;
  return {Eigen::Quaterniond(R_world_camera), position};
}

}  // namespace rigidformer
