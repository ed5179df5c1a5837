// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/shape_camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "rigidformer/scene/surface_sampling.hpp"
#include "rigidformer/simulation/builtin_shapes.hpp"

namespace rigidformer::testing {

namespace {

constexpr int kSamplesPerPoint = 6;     // samples of the whole surface, of which the camera sees and hits some; by eye
constexpr float kSurfaceGap = 0.005F;   // [m] at size 1, so that a point does not hide itself; by eye
constexpr double kOutlierExtent = 1.5;  // [extents of the shape's box] box of the outliers; by eye

// Tells whether the segment from `a` to `b` passes through the part.
bool crosses(const ConvexPart& part, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  float enter = 0.0F;
  float leave = 1.0F;
  for (Eigen::Index f = 0; f < part.triangles.rows(); ++f) {
    const Eigen::Vector3f corner = part.vertices.row(part.triangles(f, 0));
    const Eigen::Vector3f edge_1 = part.vertices.row(part.triangles(f, 1)).transpose() - corner;
    const Eigen::Vector3f edge_2 = part.vertices.row(part.triangles(f, 2)).transpose() - corner;
    const Eigen::Vector3f normal = edge_1.cross(edge_2);
    const float at_a = normal.dot(a - corner);
    const float slope = normal.dot(b - a);
    if (slope == 0.0F && at_a > 0.0F) {
      return false;
    }
    if (slope < 0.0F) {
      enter = std::max(enter, -at_a / slope);
    } else if (slope > 0.0F) {
      leave = std::min(leave, -at_a / slope);
    }
    if (enter >= leave) {
      return false;
    }
  }
  return true;
}

Shape find_shape(const std::string& name) {
  for (const Shape& shape : builtin_shapes()) {
    if (shape.name == name) {
      return shape;
    }
  }
  throw std::invalid_argument("no builtin shape is called '" + name + "'");
}

}  // namespace

ShapeCamera::ShapeCamera(const std::string& shape, double size, std::uint64_t seed)
    : shape_(find_shape(shape)), size_(size), random_(seed) {
  const Points vertices = shape_.vertices();
  lower_ = vertices.colwise().minCoeff();
  upper_ = vertices.colwise().maxCoeff();
}

View ShapeCamera::look(const RigidTransform& T_world_object, const Eigen::Vector3d& eye_world, int count,
                       const Imperfections& imperfections) {
  const Eigen::Vector3f eye = ((T_world_object.inverse() * eye_world) / size_).cast<float>();
  const auto seed = static_cast<std::uint64_t>(random_.uniform_int(0, std::numeric_limits<int>::max()));
  const SurfaceSamples surface = sample_surface(shape_, kSamplesPerPoint * count, seed);
  std::vector<Eigen::Index> seen;
  int visible = 0;
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i) {
    const Eigen::Vector3f point = surface.points.row(i);
    const float cosine = surface.normals.row(i).dot((eye - point).transpose().normalized());
    if (cosine > 0.0F && !is_hidden(point, eye)) {
      ++visible;
      if (random_.uniform(0.0, 1.0) < cosine && static_cast<int>(seen.size()) < count) {
        seen.push_back(i);
      }
    }
  }
  View view;
  view.visible_share = static_cast<double>(visible) / static_cast<double>(surface.points.rows());
  view.points_world.resize(static_cast<Eigen::Index>(seen.size()), 3);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    view.points_world.row(static_cast<Eigen::Index>(i)) = surface.points.row(seen[i]) * static_cast<float>(size_);
  }
  view.points_world = T_world_object.apply(view.points_world);
  spoil(view.points_world, T_world_object, imperfections);
  return view;
}

Points ShapeCamera::sample(const RigidTransform& T_world_object, int count, const Imperfections& imperfections) {
  const auto seed = static_cast<std::uint64_t>(random_.uniform_int(0, std::numeric_limits<int>::max()));
  const Points surface = sample_surface(shape_, count, seed).points * static_cast<float>(size_);
  Points points_world = T_world_object.apply(surface);
  spoil(points_world, T_world_object, imperfections);
  return points_world;
}

bool ShapeCamera::is_hidden(const Eigen::Vector3f& point, const Eigen::Vector3f& eye) const {
  const Eigen::Vector3f start = point + kSurfaceGap * (eye - point).normalized();
  return std::any_of(shape_.parts.begin(), shape_.parts.end(),
                     [&](const ConvexPart& part) { return crosses(part, start, eye); });
}

void ShapeCamera::spoil(Points& points_world, const RigidTransform& T_world_object,
                        const Imperfections& imperfections) {
  const Eigen::Vector3d middle = 0.5 * size_ * (lower_ + upper_).cast<double>();
  const Eigen::Vector3d reach = 0.5 * kOutlierExtent * size_ * (upper_ - lower_).cast<double>();
  for (Eigen::Index i = 0; i < points_world.rows(); ++i) {
    if (random_.uniform(0.0, 1.0) < imperfections.outlier_share) {
      const Eigen::Vector3d offset(random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0));
      points_world.row(i) = (T_world_object * (middle + reach.cwiseProduct(offset))).cast<float>().transpose();
    }
    const Eigen::Vector3d noise(normal_deviate(), normal_deviate(), normal_deviate());
    points_world.row(i) += (imperfections.noise_m * noise).cast<float>().transpose();
  }
}

double ShapeCamera::normal_deviate() {
  return std::sqrt(-2.0 * std::log(1.0 - random_.uniform(0.0, 1.0))) * std::cos(random_.uniform(0.0, 2.0 * M_PI));
}

RigidTransform Tumble::pose(double t) const {
  const double rate = angular_velocity.norm();
  const Eigen::Quaterniond turn = rate > 0.0 ? Eigen::Quaterniond(Eigen::AngleAxisd(rate * t, angular_velocity / rate))
                                             : Eigen::Quaterniond::Identity();
  return {turn, start + velocity * t + Eigen::Vector3d(0.0, 0.0, 0.5 * gravity * t * t)};
}

PoseError pose_error(const RigidTransform& T_tracked, const RigidTransform& T_tracked_first,
                     const RigidTransform& T_true, const RigidTransform& T_true_first) {
  const RigidTransform T_estimated = T_tracked * T_tracked_first.inverse() * T_true_first;
  return {(T_estimated.translation - T_true.translation).norm(), rotation_angle(T_estimated.rotation, T_true.rotation)};
}

}  // namespace rigidformer::testing
