// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/varied_scene.hpp"

#include <cmath>

#include "random_draws.hpp"

namespace rigidformer {
namespace {

constexpr std::uint64_t kVariationStream = 0x76617279;  // apart from the stream that draws the scene; any number does

// All ranges were chosen by eye. Materials: the products of object and floor, which count in a contact, then cover
// friction 0.04 ... 1.4 and restitution 0 ... 0.9, as tables have it for pairs of real materials.
constexpr Range kObjectFriction{0.2, 1.2}, kFloorFriction{0.2, 1.2};
constexpr Range kObjectRestitution{0.0, 0.95}, kFloorRestitution{0.2, 0.95};
// Sizes: MOVi's 0.7 ... 1.4 become 0.04 ... 2.1. Masses: density beyond MOVi's factors, which a unit cannot matter to.
constexpr Range kSceneScale{0.15, 1.5}, kShrinking{0.4, 1.0}, kDensity{0.3, 3.0};
constexpr Range kSpin_radps{-4.0, 4.0}, kVerticalSpeed_mps{-2.0, 2.0};  // at scale 1
constexpr double kGravities[] = {-10.0, -9.81};                         // [m/s^2] of MOVi, and of Europe
constexpr double kLevelShare = 0.5;                                     // of the floors
constexpr Range kTilt_rad{0.0, 0.026};                                  // of the others, up to 1.5 degrees
constexpr double kHardShare = 0.5;  // of the scenes without spinning and rolling friction, and without softness
constexpr Range kSpinningFriction{0.005, 0.1}, kRollingFriction{0.001, 0.03};  // of the radius
constexpr double kMoviMargin_m = 0.001;                                        // at scale 1

void vary_object(RecordedObject& object, double scale, Random& random) {
  const double shrinking = draw_magnitude(random, kShrinking);
  object.size *= shrinking * scale;
  BodyProperties& p = object.properties;
  *p.mass_kg *= std::pow(shrinking, 3) * draw_magnitude(random, kDensity);
  p.friction = draw_magnitude(random, kObjectFriction);
  p.restitution = draw(random, kObjectRestitution);
  object.T_world_object.front().translation *= scale;
  object.velocities.front().z() += draw(random, kVerticalSpeed_mps);
  object.velocities.front() *= std::sqrt(scale);
  for (int axis = 0; axis < 3; ++axis) {
    object.angular_velocities.front()[axis] = draw(random, kSpin_radps) / std::sqrt(scale);
  }
}

Eigen::Vector3d draw_gravity(Random& random) {
  const double gravity = kGravities[random.uniform_int(0, 1)];
  const double tilt_rad = draw_chance(random, kLevelShare) ? 0.0 : draw(random, kTilt_rad);
  const double direction_rad = random.uniform(0.0, 2.0 * M_PI);
  return gravity * Eigen::Vector3d(std::sin(tilt_rad) * std::cos(direction_rad),
                                   std::sin(tilt_rad) * std::sin(direction_rad), std::cos(tilt_rad));
}

void vary_solver(BulletSettings& bullet, double scale, Random& random) {
  bullet.substeps = random.uniform_int(5, 20);
  bullet.solver_iterations = random.uniform_int(20, 100);
  bullet.contact_erp = draw_magnitude(random, {0.03, 0.3});
  bullet.friction_erp = draw_magnitude(random, {0.1, 0.4});
  bullet.contact_cfm = draw_chance(random, kHardShare) ? 0.0 : draw_magnitude(random, {1e-6, 1e-4});
  bullet.hull_margin_m = kMoviMargin_m * scale;
}

void vary_solver(MujocoSettings& mujoco, Random& random) {
  mujoco.substeps = random.uniform_int(8, 16);
  mujoco.steps_per_contact = random.uniform(8.0, 20.0);
  mujoco.impedance = random.uniform(0.9, 0.99);
  mujoco.friction_impedance = draw_magnitude(random, {2.0, 20.0});
  mujoco.spinning_friction_m = 0.0;
}

template <typename Settings>
void apply_world(const SceneRecording& start, double spinning_friction, double rolling_friction, Settings& settings) {
  settings.gravity = start.gravity;
  settings.floor_friction = *start.ground.friction;
  settings.floor_restitution = *start.ground.restitution;
  settings.spinning_friction = spinning_friction;
  settings.rolling_friction = rolling_friction;
}

}  // namespace

VariedScene sample_varied_scene(MoviSet set, const std::vector<Shape>& shapes, std::uint64_t seed, std::uint64_t index,
                                MoviOptions options) {
  options.min_objects = 1;
  VariedScene varied{sample_movi_scene(set, shapes, seed, index, options), movi_bullet_settings(set), {}};
  Random random(seed ^ kVariationStream, index);
  const double scale = varied.scale = draw_magnitude(random, kSceneScale);
  SceneRecording& start = varied.start;
  for (RecordedObject& object : start.objects) vary_object(object, scale, random);
  start.gravity = draw_gravity(random);
  start.ground = {draw_magnitude(random, kFloorFriction), draw(random, kFloorRestitution)};
  const bool is_hard = draw_chance(random, kHardShare);
  const double spinning = is_hard ? 0.0 : draw_magnitude(random, kSpinningFriction);
  const double rolling = is_hard ? 0.0 : draw_magnitude(random, kRollingFriction);
  apply_world(start, spinning, rolling, varied.bullet);
  apply_world(start, spinning, rolling, varied.mujoco);
  vary_solver(varied.bullet, scale, random);
  vary_solver(varied.mujoco, random);
  return varied;
}

}  // namespace rigidformer
