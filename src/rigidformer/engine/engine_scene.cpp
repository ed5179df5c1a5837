// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "engine_scene.hpp"

#include <cmath>
#include <optional>

#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {
namespace {

constexpr double kCarriedSpeed_mps = 0.3;  // vertical, below which what touches the ground lies or rolls
constexpr double kCertainSpeed_mps = 0.5;  // of the fastest point, above which a body is not about to tip

double value(const Tensor& tensor) { return tensor.item<double>(); }

/// Material of the ground of scene `b` as far as it is known.
GroundProperties known_ground(const SceneBatch& batch, std::int64_t b) {
  if (!batch.ground_material.defined()) return {};
  const auto property = [&](std::int64_t i) {
    return value(batch.ground_known[b][i]) > 0.0 ? std::optional<double>(value(batch.ground_material[b][i]))
                                                 : std::nullopt;
  };
  return {property(0), property(1)};
}

bool is_finite(const BodyState& state) {
  return is_valid(state.T_world_object) && state.velocity.allFinite() && state.angular_velocity.allFinite();
}

}  // namespace

EngineScene::EngineScene(const SceneBatch& batch, const Tensor& centre_reference, std::int64_t b)
    : scene_(b),
      time_step_s_(value(batch.step_size[b]) / kFrameRateHz),
      gravity_(value(batch.gravity[b])),
      ground_height_m_(value(batch.ground_height[b])),
      world_(observed_world(time_step_s_, gravity_, known_ground(batch, b))) {
  const std::vector<ObservedSolid> solids = observe_solids(batch, centre_reference, b);
  double total_mass_kg = 0.0;
  for (const ObservedSolid& solid : solids) total_mass_kg += *solid.properties.mass_kg;
  // Only ratios of masses matter to the motion, but the solver's tolerances are meant for masses of about 1 kg.
  const double mass_unit_kg = total_mass_kg / static_cast<double>(solids.size());
  for (const ObservedSolid& solid : solids) add_body(solid, mass_unit_kg);
}

void EngineScene::add_body(const ObservedSolid& solid, double mass_unit_kg) {
  const Shape shape{"", 1.0, {solid.hull}};
  BodyProperties properties = solid.properties;
  *properties.mass_kg /= mass_unit_kg;
  if (solid.dynamic) {
    world_.add_body(shape, 1.0, properties, {});
  } else {
    world_.add_driven_body(shape, 1.0, properties, {});
  }
  bodies_.push_back({solid.object, solid.dynamic, solid.centre_reference, solid.hull.vertices, solid.fully_known});
}

void EngineScene::step(PoseTable& previous, PoseTable& current, Tensor& certain) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    const BodyState state = observe(body, previous.get(scene_, body.object), current.get(scene_, body.object));
    world_.set_state(static_cast<int>(i), state);
    certain[scene_][body.object] = is_certain(body, state);
  }
  world_.step_frame();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    const BodyState arrived = world_.state(static_cast<int>(i));
    if (!is_finite(arrived)) continue;  // the object stays where it is
    previous.set(scene_, body.object, from_ground(body, departure(body, arrived)));
    current.set(scene_, body.object, from_ground(body, arrived.T_world_object));
  }
}

BodyState EngineScene::observe(const Body& body, const RigidTransform& before, const RigidTransform& now) const {
  BodyState state = mean_motion(on_ground(body, before), on_ground(body, now), time_step_s_);
  if (falls(body, state)) state.velocity.z() += fall_before_step();
  return state;
}

RigidTransform EngineScene::departure(const Body& body, const BodyState& arrived) const {
  Eigen::Vector3d velocity = arrived.velocity;
  if (falls(body, arrived)) velocity.z() -= fall_before_step();
  const Eigen::Quaterniond back = rotation_about(-time_step_s_ * arrived.angular_velocity);
  return {back * arrived.T_world_object.rotation, arrived.T_world_object.translation - velocity * time_step_s_};
}

/// Bullet moves by the velocity after a kick of gravity: starting half a kick back makes free flight exact.
double EngineScene::fall_before_step() const {
  const int kicks = observed_world(time_step_s_, gravity_, {}).substeps;
  return half_fall(time_step_s_, gravity_) * (1.0 - 1.0 / kicks);
}

/// Whether something keeps still or tips over depends on the few points it stands on, which a sampled hull misses.
bool EngineScene::is_certain(const Body& body, const BodyState& state) {
  const double radius = static_cast<double>(body.hull.rowwise().norm().maxCoeff());
  return body.fully_known && state.velocity.norm() + radius * state.angular_velocity.norm() > kCertainSpeed_mps;
}

bool EngineScene::falls(const Body& body, const BodyState& state) const {
  const bool carried =
      std::abs(state.velocity.z()) < kCarriedSpeed_mps && touches_floor(body.hull, state.T_world_object);
  return body.dynamic && !carried;
}

RigidTransform EngineScene::on_ground(const Body& body, const RigidTransform& T_world_reference) const {
  return {T_world_reference.rotation,
          T_world_reference * body.centre_reference - Eigen::Vector3d(0.0, 0.0, ground_height_m_)};
}

RigidTransform EngineScene::from_ground(const Body& body, RigidTransform T_ground_body) const {
  T_ground_body.translation.z() += ground_height_m_;
  T_ground_body.translation -= T_ground_body.rotation * body.centre_reference;
  return T_ground_body;
}

}  // namespace rigidformer
