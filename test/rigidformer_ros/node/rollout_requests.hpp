// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>

#include "rigidformer_ros/node/node_client.hpp"

namespace rigidformer_ros::testing {

using Response = Rollout::Response;

/// A flight that rises from 8 m and is above z = 0 for 1.7 s.
inline Flight high_flight(double x = 0.0) {
  Flight flight;
  flight.start = {x, 0.0, 8.0};
  flight.velocity = {0.5, -0.2, 4.0};
  return flight;
}

inline Flight without_spin(Flight flight) {
  flight.angular_velocity.setZero();
  return flight;
}

/// A motion along x that does not fall.
inline Flight sliding() {
  Flight flight = without_spin(high_flight());
  flight.velocity = {0.5, 0.0, 0.0};
  flight.gravity = 0.0;
  return flight;
}

/// A scene for a request: the cloud of the flight at time `t` [s], stamped 50 s + `t`.
inline ObjectClouds scene_at(double t, const Flight& flight) {
  ObjectClouds scene;
  scene.header.stamp = ros::Time(50.0 + t);
  scene.ids = {"planned"};
  scene.clouds = {to_cloud(flight.pose(t).apply(blob()))};
  return scene;
}

/// A change that spoils a good request. The answer must have this code, and its message must contain `part`.
struct BadRequest {
  const char* name;
  std::int32_t code;
  const char* part;
  std::function<void(Rollout::Request&)> change;
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

inline const BadRequest kBadRequests[] = {
    {"huge steps", Response::LIMIT_EXCEEDED, "num_steps", [](auto& r) { r.num_steps = 4000000000U; }},
    {"NaN step", Response::INVALID_REQUEST, "time_step", [](auto& r) { r.time_step = kNan; }},
    {"negative step", Response::INVALID_REQUEST, "time_step", [](auto& r) { r.time_step = -0.01; }},
    {"long step", Response::INVALID_REQUEST, "trained for", [](auto& r) { r.time_step = 0.5; }},
    {"short step", Response::INVALID_REQUEST, "time_step", [](auto& r) { r.time_step = 1e-4; }},
    {"unknown id", Response::UNKNOWN_OBJECT, "object_ids[1]",
     [](auto& r) {
       r.object_ids = {"a", "ghost"};
     }},
    {"double id", Response::INVALID_REQUEST, "object_ids[1]",
     [](auto& r) {
       r.object_ids = {"a", "a"};
     }},
    {"old state", Response::STALE_STATE, "max_state_age", [](auto& r) { r.max_state_age = ros::Duration(1e-4); }},
    {"negative age", Response::INVALID_REQUEST, "max_state_age",
     [](auto& r) { r.max_state_age = ros::Duration(-1.0); }},
    {"negative wall time", Response::INVALID_REQUEST, "max_wall_time",
     [](auto& r) { r.max_wall_time = ros::Duration(-1.0); }},
    {"no wall time", Response::TIMED_OUT, "max_wall_time",
     [](auto& r) { r.num_steps = 500, r.max_wall_time = ros::Duration(1e-9); }},
    {"sparse record", Response::INVALID_REQUEST, "record_every", [](auto& r) { r.record_every = 4000; }},
    {"candidate", Response::INVALID_REQUEST, "candidate.overrides[0]",
     [](auto& r) {
       r.candidate.overrides.resize(1);
       r.candidate.overrides[0].fields = 16;
     }},
    {"lone previous", Response::INVALID_REQUEST, "previous_scene",
     [](auto& r) { r.previous_scene = scene_at(0.0, high_flight()); }},
    {"missing cloud", Response::INVALID_REQUEST, "scene.clouds",
     [](auto& r) { r.scene = scene_at(0.0, high_flight()), r.scene.clouds.clear(); }},
    {"surplus mode", Response::INVALID_REQUEST, "scene.modes",
     [](auto& r) {
       r.scene = scene_at(0.0, high_flight()), r.scene.modes = {0, 0};
     }},
    {"wrong mode", Response::INVALID_REQUEST, "must be DYNAMIC",
     [](auto& r) { r.scene = scene_at(0.0, high_flight()), r.scene.modes = {7}; }},
    {"empty id", Response::INVALID_REQUEST, "scene.ids[0]",
     [](auto& r) { r.scene = scene_at(0.0, high_flight()), r.scene.ids[0] = ""; }},
    {"broken cloud", Response::INVALID_REQUEST, "row_step",
     [](auto& r) { r.scene = scene_at(0.0, high_flight()), r.scene.clouds[0].row_step = 1; }},
    {"tiny cloud", Response::INVALID_REQUEST, "finite points",
     [](auto& r) { r.scene = scene_at(0.0, high_flight()), r.scene.clouds[0] = to_cloud(blob(2)); }},
    {"bad quaternion", Response::INVALID_REQUEST, "orientation",
     [](auto& r) { r.scene = scene_at(0.0, high_flight()), r.scene.poses.resize(1); }},
    {"unknown frame", Response::FRAME_TRANSFORM_FAILURE, "nowhere",
     [](auto& r) { r.scene = scene_at(0.0, high_flight()), r.scene.header.frame_id = "nowhere"; }},
    {"other objects", Response::INVALID_REQUEST, "previous_scene.ids",
     [](auto& r) {
       r.scene = scene_at(0.04, high_flight());
       r.previous_scene = scene_at(0.0, high_flight());
       r.previous_scene.ids[0] = "other";
     }},
    {"other points", Response::INVALID_REQUEST, "other points",
     [](auto& r) {
       r.scene = scene_at(0.04, high_flight());
       r.previous_scene = scene_at(0.0, high_flight());
       r.previous_scene.clouds[0] = to_cloud(blob(12));
     }},
    {"reversed scenes", Response::INVALID_REQUEST, "previous_scene.header.stamp",
     [](auto& r) {
       r.scene = scene_at(0.0, high_flight());
       r.previous_scene = scene_at(0.04, high_flight());
     }},
    {"close scenes", Response::INSUFFICIENT_HISTORY, "previous_scene.header.stamp",
     [](auto& r) {
       r.scene = scene_at(0.01, high_flight());
       r.previous_scene = scene_at(0.0, high_flight());
     }},
};

}  // namespace rigidformer_ros::testing
