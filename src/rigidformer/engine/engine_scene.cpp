// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "engine_scene.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "rigidformer/simulation/observed_motion.hpp"

namespace rigidformer {
namespace {

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

bool is_same(const RigidTransform& a, const RigidTransform& b) {
  return a.translation == b.translation && a.rotation.coeffs() == b.rotation.coeffs();
}

bool is_finite(const BodyState& state) {
  return is_valid(state.T_world_object) && state.velocity.allFinite() && state.angular_velocity.allFinite();
}

}  // namespace

EngineScene::EngineScene(const SceneBatch& batch, std::vector<ObservedSolid> solids, std::int64_t b, Sleep sleep)
    : scene_(b),
      time_step_s_(value(batch.step_size[b]) / kFrameRateHz),
      gravity_(value(batch.gravity[b])),
      ground_height_m_(value(batch.ground_height[b])),
      world_(observed_world(time_step_s_, gravity_, known_ground(batch, b))),
      bodies_(std::move(solids), 0.0),
      sleep_(sleep) {
  double total_mass_kg = 0.0;
  for (const ObservedSolid& solid : bodies_.solids()) total_mass_kg += *solid.properties.mass_kg;
  // Only ratios of masses matter to the motion, but the solver's tolerances are meant for masses of about 1 kg.
  mass_unit_kg_ = total_mass_kg / static_cast<double>(bodies_.solids().size());
  for (const ObservedSolid& solid : bodies_.solids()) add_body(solid);
}

void EngineScene::add_body(const ObservedSolid& solid) {
  BodyProperties properties = solid.properties;
  *properties.mass_kg /= mass_unit_kg_;
  if (solid.dynamic) {
    world_.add_body(solid.shape, properties, {});
  } else {
    world_.add_driven_body(solid.shape, properties, {});
  }
}

void EngineScene::step(const EngineStepPoses& poses) {
  const std::vector<ObservedSolid>& bodies = bodies_.solids();
  const std::vector<bool> asleep = find_sleepers(poses);
  const std::vector<BodyState> states = observe(poses);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    world_.set_state(static_cast<int>(i), states[i]);
    world_.set_asleep(static_cast<int>(i), asleep[i]);
  }
  world_.step_frame();
  keep_pressed(asleep);
  std::vector<BodyState> arrived;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyState state = world_.state(static_cast<int>(i));
    arrived.push_back(is_finite(state) ? state : states[i]);
  }
  const std::vector<bool> falls = fall(arrived);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!is_finite(world_.state(static_cast<int>(i)))) continue;  // the object stays where it is
    poses.previous.set(scene_, bodies[i].object, from_ground(bodies[i], departure(arrived[i], falls[i])));
    poses.current.set(scene_, bodies[i].object, from_ground(bodies[i], arrived[i].T_world_object));
  }
}

std::vector<PressedPair> EngineScene::pressed() const {
  const auto object = [&](int body) { return body < 0 ? -1 : bodies_.solids()[static_cast<std::size_t>(body)].object; };
  std::vector<PressedPair> pairs;
  for (const PressedBodies& pair : pressed_) {
    pairs.push_back({scene_, object(pair.body_a), object(pair.body_b), pair.normal_impulse_Ns * mass_unit_kg_});
  }
  return pairs;
}

std::vector<bool> EngineScene::find_sleepers(const EngineStepPoses& poses) {
  const std::vector<ObservedSolid>& bodies = bodies_.solids();
  std::vector<bool> asleep(bodies.size(), false);
  if (sleep_ == Sleep::kNever) return asleep;
  std::vector<RigidTransform> T_world_now;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const RigidTransform now = poses.current.get(scene_, bodies[i].object);
    const PoseTable& beside = bodies[i].dynamic ? poses.previous : poses.coming;
    asleep[i] = !T_world_stepped_.empty() && is_same(now, T_world_stepped_[i]) &&
                is_same(now, beside.get(scene_, bodies[i].object));
    T_world_now.push_back(now);
  }
  T_world_stepped_ = std::move(T_world_now);
  return asleep;
}

/// Sleepers press as they did when they fell asleep.
void EngineScene::keep_pressed(const std::vector<bool>& asleep) {
  const auto sleeps = [&](int body) { return body < 0 || asleep[static_cast<std::size_t>(body)]; };
  std::vector<PressedBodies> pressed = world_.pressed();
  for (const PressedBodies& pair : pressed_) {
    const auto is_pair = [&](const PressedBodies& p) { return p.body_a == pair.body_a && p.body_b == pair.body_b; };
    if (!sleeps(pair.body_a) || !sleeps(pair.body_b)) continue;
    if (std::none_of(pressed.begin(), pressed.end(), is_pair)) pressed.push_back(pair);
  }
  pressed_ = std::move(pressed);
}

/// What is given already has the velocity with which it comes to its next pose.
std::vector<BodyState> EngineScene::observe(const EngineStepPoses& poses) const {
  std::vector<BodyState> states;
  for (const ObservedSolid& body : bodies_.solids()) {
    const RigidTransform now = on_ground(body, poses.current.get(scene_, body.object));
    if (body.dynamic) {
      states.push_back(mean_motion(on_ground(body, poses.previous.get(scene_, body.object)), now, time_step_s_));
    } else {
      states.push_back(mean_motion(now, on_ground(body, poses.coming.get(scene_, body.object)), time_step_s_));
      states.back().T_world_object = now;
    }
  }
  const std::vector<bool> falls = fall(states);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (falls[i]) states[i].velocity.z() += fall_before_step();
  }
  return states;
}

std::vector<bool> EngineScene::fall(const std::vector<BodyState>& states) const {
  std::vector<RigidTransform> T_ground_body;
  std::vector<double> rising_mps;
  for (const BodyState& state : states) {
    T_ground_body.push_back(state.T_world_object);
    rising_mps.push_back(state.velocity.z());
  }
  std::vector<bool> falls = bodies_.carried(T_ground_body, rising_mps);
  for (std::size_t i = 0; i < falls.size(); ++i) falls[i] = bodies_.solids()[i].dynamic && !falls[i];
  return falls;
}

RigidTransform EngineScene::departure(const BodyState& arrived, bool falls) const {
  Eigen::Vector3d velocity = arrived.velocity;
  if (falls) velocity.z() -= fall_before_step();
  const Eigen::Quaterniond back = rotation_about(-time_step_s_ * arrived.angular_velocity);
  return {back * arrived.T_world_object.rotation, arrived.T_world_object.translation - velocity * time_step_s_};
}

/// Bullet moves by the velocity after a kick of gravity: starting half a kick back makes free flight exact.
double EngineScene::fall_before_step() const {
  const int kicks = observed_world(time_step_s_, gravity_, {}).substeps;
  return half_fall(time_step_s_, gravity_) * (1.0 - 1.0 / kicks);
}

RigidTransform EngineScene::on_ground(const ObservedSolid& body, const RigidTransform& T_world_reference) const {
  return {T_world_reference.rotation,
          T_world_reference * body.centre_reference - Eigen::Vector3d(0.0, 0.0, ground_height_m_)};
}

RigidTransform EngineScene::from_ground(const ObservedSolid& body, RigidTransform T_ground_body) const {
  T_ground_body.translation.z() += ground_height_m_;
  T_ground_body.translation -= T_ground_body.rotation * body.centre_reference;
  return T_ground_body;
}

}  // namespace rigidformer
