// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/engine/body_motion.hpp"

#include <stdexcept>

#include "rigidformer/simulation/mesh_volume.hpp"
#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {

#ifdef RIGIDFORMER_HAS_BULLET

namespace {

/// What gravity adds to the mean velocity of the last step [m/s]; 0 for what is carried or given.
double fall_of(const SolidScene& scene, const BodyPoses& poses, std::size_t body, const BodyState& motion) {
  std::vector<double> rising_mps;
  for (std::size_t i = 0; i < poses.now.size(); ++i) {
    rising_mps.push_back((poses.now[i].translation.z() - poses.before[i].translation.z()) / poses.time_step_s);
  }
  rising_mps[body] = motion.velocity.z();
  const bool is_carried = scene.carried(poses.now, rising_mps)[body];
  return scene.solids()[body].dynamic && !is_carried ? half_fall(poses.time_step_s, poses.gravity) : 0.0;
}

}  // namespace

BodyState motion_now(const SolidScene& scene, const BodyPoses& poses, int body) {
  const auto i = static_cast<std::size_t>(body);
  BodyState motion = mean_motion(poses.before[i], poses.now[i], poses.time_step_s);
  motion.velocity.z() += fall_of(scene, poses, i, motion);
  return motion;
}

RigidTransform departure(const SolidScene& scene, const BodyPoses& poses, int body, const BodyState& motion) {
  const auto i = static_cast<std::size_t>(body);
  Eigen::Vector3d mean = motion.velocity;
  mean.z() -= fall_of(scene, poses, i, motion);
  const Eigen::Quaterniond back = rotation_about(-poses.time_step_s * motion.angular_velocity);
  return {(back * poses.now[i].rotation).normalized(), poses.now[i].translation - mean * poses.time_step_s};
}

BodyState pushed(const ObservedSolid& solid, BodyState motion, const Eigen::Vector3d& impulse_Ns,
                 const Eigen::Vector3d& angular_impulse_Nms, const Eigen::Vector3d& point) {
  const double mass_kg = *solid.properties.mass_kg;
  const Eigen::Matrix3d R = motion.T_world_object.rotation.toRotationMatrix();
  const Eigen::Matrix3d inertia = mass_kg * R * inertia_per_mass(*solid.hull) * R.transpose();
  motion.velocity += impulse_Ns / mass_kg;
  motion.angular_velocity += inertia.ldlt().solve(point.cross(impulse_Ns) + angular_impulse_Nms);
  return motion;
}

#else

namespace {

[[noreturn]] void need_bullet() {
  throw std::runtime_error("twists and impulses need the shapes of objects: install libbullet-dev and build again");
}

}  // namespace

BodyState motion_now(const SolidScene&, const BodyPoses&, int) { need_bullet(); }
RigidTransform departure(const SolidScene&, const BodyPoses&, int, const BodyState&) { need_bullet(); }
BodyState pushed(const ObservedSolid&, BodyState, const Eigen::Vector3d&, const Eigen::Vector3d&,
                 const Eigen::Vector3d&) {
  need_bullet();
}

#endif

}  // namespace rigidformer
