// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "rigidformer/geometry/random.hpp"
#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/scene/shape.hpp"
#include "rigidformer/tracking/options.hpp"

namespace rigidformer::testing {

/// The faults of a camera. The values were chosen by eye.
struct Imperfections {
  double noise_m = 0.003;       ///< Standard deviation along each axis [m]
  double outlier_share = 0.05;  ///< Share of points that lie anywhere in a box of 1.5 times the object's extents
};

struct View {
  Points points_world;
  double visible_share = 0.0;  ///< Share of the surface that the camera sees
};

/// A depth camera in front of one builtin shape. Every view draws other points; the same seed gives the same series.
class ShapeCamera {
 public:
  /// Throws std::invalid_argument for an unknown shape. `size` scales it (size 1: about a metre).
  ShapeCamera(const std::string& shape, double size, std::uint64_t seed);

  /// Gives at most `count` points that `eye_world` sees of the shape at the given pose, as dense as pixels are.
  View look(const RigidTransform& T_world_object, const Eigen::Vector3d& eye_world, int count,
            const Imperfections& imperfections = {});

  /// Gives `count` points of the whole surface.
  Points sample(const RigidTransform& T_world_object, int count, const Imperfections& imperfections = {});

  Random& random() { return random_; }

 private:
  bool is_hidden(const Eigen::Vector3f& point, const Eigen::Vector3f& eye) const;
  void spoil(Points& points_world, const RigidTransform& T_world_object, const Imperfections& imperfections);
  double normal_deviate();

  Shape shape_;
  double size_;
  Random random_;
  Eigen::Vector3f lower_;
  Eigen::Vector3f upper_;
};

/// A body that flies freely with a constant spin, from the origin of its own path.
struct Tumble {
  Eigen::Vector3d start{0.0, 0.0, 0.0};
  Eigen::Vector3d velocity{0.4, 0.2, 1.0};
  Eigen::Vector3d angular_velocity{1.5, -2.5, 2.0};
  double gravity = -1.0;

  RigidTransform pose(double t) const;
};

/// Pose error of a tracked object whose frame differs from the true one: `T_tracked` and `T_true` are poses now, and
/// the other two are those when the track began. The position is that of the true centre.
struct PoseError {
  double position_m;
  double rotation_rad;
};
PoseError pose_error(const RigidTransform& T_tracked, const RigidTransform& T_tracked_first,
                     const RigidTransform& T_true, const RigidTransform& T_true_first);

}  // namespace rigidformer::testing
