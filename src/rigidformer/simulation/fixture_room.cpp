// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fixture_room.hpp"

#include <algorithm>

#include "scene_recorder.hpp"

namespace rigidformer {
namespace {

using Eigen::Vector3d;

// All chosen by eye; lengths [m] where objects are about 1 m large, times and speeds likewise.
constexpr double kWaySamples = 40.0, kStride = 0.04, kDrop = 0.01, kNear = 0.9, kRestSpeed = 0.02;
constexpr int kHalvings = 12, kMostFramesToRest = 300, kFramesAtRest = 12;

const BodyProperties kAnyMaterial{1.0, 0.6, 0.0};  // of what only stands in the way

}  // namespace

int FixtureRoom::add_given(BulletWorld& world, const Block& block, const RigidTransform& T_world_block) const {
  const int body = world.add_driven_body(find_shape(shapes_, block.shape), block.size, kAnyMaterial, {T_world_block});
  world.follow(body, standing_at(T_world_block));
  return body;
}

void FixtureRoom::add_static(const Block& block, const RigidTransform& T_world_block) {
  add_given(world_, block, T_world_block);
  add_given(obstacles_, block, T_world_block);
}

bool FixtureRoom::has_way(const Driver& driver, double duration_s) {
  for (std::size_t i = 0; i < driver.blocks.size(); ++i) {
    const Block& block = driver.blocks[i];
    const int body = add_given(obstacles_, block, driver.paths[i](0.0));
    const Points corners = static_cast<float>(block.size) * find_shape(shapes_, block.shape).vertices();
    bool is_free = true;
    for (double sample = 0.0; is_free && sample <= kWaySamples; ++sample) {
      const double time_s = sample / kWaySamples * duration_s;
      const RigidTransform T = driver.paths[i](time_s);
      for (std::size_t k = 0; k < driver_paths_.size(); ++k) {
        obstacles_.set_state(driver_bodies_[k], {driver_paths_[k](time_s)});
      }
      obstacles_.set_state(body, {T});
      is_free = T.apply(corners).col(2).minCoeff() >= 0.0F && !obstacles_.overlaps_any(body);
    }
    obstacles_.remove_last_body();
    if (!is_free) return false;
  }
  return true;
}

bool FixtureRoom::add_driver(const Driver& driver) {
  for (std::size_t i = 0; i < driver.blocks.size(); ++i) {
    const int body = add_given(world_, driver.blocks[i], driver.paths[i](0.0));
    if (!world_.overlaps_any(body)) continue;
    for (std::size_t added = 0; added <= i; ++added) world_.remove_last_body();
    return false;
  }
  for (std::size_t i = 0; i < driver.blocks.size(); ++i) {
    driver_bodies_.push_back(add_given(obstacles_, driver.blocks[i], driver.paths[i](0.0)));
    driver_paths_.push_back(driver.paths[i]);
  }
  return true;
}

Eigen::AlignedBox3d FixtureRoom::bounds(const RecordedObject& object, const RigidTransform& T_world_object) const {
  const Points corners =
      T_world_object.apply(static_cast<float>(object.size) * find_shape(shapes_, object.shape).vertices());
  return {corners.colwise().minCoeff().transpose().cast<double>(),
          corners.colwise().maxCoeff().transpose().cast<double>()};
}

std::optional<RigidTransform> FixtureRoom::seat(const RecordedObject& object, const Vector3d& foot_world,
                                                Random& random) {
  RigidTransform T{random.rotation(), Vector3d::Zero()};
  T.translation = foot_world + Vector3d(0.0, 0.0, kDrop * unit_m_ - bounds(object, T).min().z());
  if (!add_free(object, T)) return std::nullopt;
  const int body = world_.num_bodies() - 1;
  if (comes_to_rest(body, foot_world)) {
    const RigidTransform at_rest = world_.state(body).T_world_object;
    world_.set_state(body, {at_rest});
    world_.set_asleep(body, true);
    return at_rest;
  }
  world_.remove_last_body();
  return std::nullopt;
}

bool FixtureRoom::comes_to_rest(int body, const Vector3d& foot_world) {
  int frames_at_rest = 0;
  for (int frame = 0; frame < kMostFramesToRest && frames_at_rest < kFramesAtRest; ++frame) {
    world_.step_frame();
    const BodyState state = world_.state(body);
    const double speed = state.velocity.norm() + unit_m_ * state.angular_velocity.norm();
    frames_at_rest = speed < kRestSpeed * std::sqrt(unit_m_) ? frames_at_rest + 1 : 0;
    const Vector3d away = state.T_world_object.translation - foot_world;
    if (away.head<2>().norm() > kNear * unit_m_ || away.z() < 0.0) return false;
  }
  return frames_at_rest >= kFramesAtRest;
}

bool FixtureRoom::add_free(const RecordedObject& object, const RigidTransform& T_world_object) {
  if (bounds(object, T_world_object).min().z() < 0.0) return false;
  const int body = world_.add_body(find_shape(shapes_, object.shape), object.size, object.properties, {T_world_object});
  if (!world_.overlaps_any(body)) return true;
  world_.remove_last_body();
  return false;
}

Reach FixtureRoom::reach() {
  return [this](const Block& block, const RigidTransform& T_world_block, const Vector3d& direction,
                double most_m) -> std::optional<double> {
    const int body = add_given(world_, block, T_world_block);
    const auto overlaps_after = [&](double way_m) {
      world_.set_state(body, {{T_world_block.rotation, T_world_block.translation + way_m * direction}});
      return world_.overlaps_any(body);
    };
    double clear_m = 0.0, touching_m = 0.0;
    bool touches = overlaps_after(0.0);
    const bool is_free = !touches;
    while (!touches && touching_m < most_m) {
      clear_m = touching_m;
      touching_m += kStride * unit_m_;
      touches = overlaps_after(touching_m);
    }
    for (int i = 0; touches && i < kHalvings; ++i) {
      const double middle_m = 0.5 * (clear_m + touching_m);
      (overlaps_after(middle_m) ? touching_m : clear_m) = middle_m;
    }
    world_.remove_last_body();
    return is_free && touches ? std::optional<double>(clear_m) : std::nullopt;
  };
}

}  // namespace rigidformer
