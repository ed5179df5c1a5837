// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

#include "rigidformer/scene/object.hpp"
#include "rigidformer/scene/rollout_options.hpp"

namespace rigidformer {

/// Corners of an axis-aligned box around `centre` in the reference frame.
inline Points box_cloud(const Eigen::Vector3d& size, const Eigen::Vector3d& centre = Eigen::Vector3d::Zero()) {
  Points points(8, 3);
  for (int v = 0; v < 8; ++v) {
    const Eigen::Vector3d sign(v & 1 ? 0.5 : -0.5, v & 2 ? 0.5 : -0.5, v & 4 ? 0.5 : -0.5);
    points.row(v) = (centre + size.cwiseProduct(sign)).transpose().cast<float>();
  }
  return points;
}

/// Points spread evenly over a sphere, both poles included.
inline Points sphere_cloud(double radius, int count = 400) {
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - 2.0 * i / (count - 1.0);
    const double angle = i * M_PI * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    points.row(i) = (radius * Eigen::RowVector3d(r * std::cos(angle), r * std::sin(angle), z)).cast<float>();
  }
  return points;
}

inline RolloutOptions rollout_of(int frames_per_step, int num_steps) {
  RolloutOptions rollout;
  rollout.time_step_s = frames_per_step / 240.0;
  rollout.num_steps = num_steps;
  return rollout;
}

/// Free flight of the reference frame's origin, with constant spin in world.
struct Flight {
  Eigen::Vector3d position, velocity;  ///< Position [m] and velocity [m/s] at t = 0
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();
  double gravity = -10.0;

  RigidTransform at(double t) const {
    const Eigen::Vector3d axis = spin.norm() > 0.0 ? spin.normalized() : Eigen::Vector3d::UnitX();
    return {Eigen::Quaterniond(Eigen::AngleAxisd(spin.norm() * t, axis)),
            position + velocity * t + Eigen::Vector3d(0.0, 0.0, 0.5 * gravity * t * t)};
  }
};

inline ObjectState flying_object(const Points& points, const Flight& flight, const RolloutOptions& rollout,
                                 const BodyProperties& properties = {}) {
  ObjectState object;
  object.id = "flying";
  object.points_reference = points;
  object.T_world_previous = flight.at(-rollout.time_step_s);
  object.T_world_current = flight.at(0.0);
  object.properties = properties;
  return object;
}

inline ObjectState resting_object(const Points& points, const Eigen::Vector3d& position,
                                  const BodyProperties& properties = {}) {
  ObjectState object;
  object.id = "resting";
  object.points_reference = points;
  object.T_world_previous.translation = object.T_world_current.translation = position;
  object.properties = properties;
  return object;
}

}  // namespace rigidformer
