// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/io/members.hpp"

namespace rigidformer_ros {

using rigidformer::between;

/// Limits of requests, parameters `service/*`.
struct ServiceParameters {
  int max_steps = 500;
  double max_wall_time = 10.0;
  double max_state_age = 0.5;
  int max_clients_queued = 4;
  int max_returned_points = 2000000;
  int max_candidates = 256;
  int max_candidate_steps = 50000;
  int max_returned_poses = 1000000;
  int num_particles = 1;
  int max_particles = 32;
  int max_particle_steps = 200000;
  int batch_threads = 1;
  double settle_linear_speed = 0.02;
  double settle_angular_speed = 0.1;
  double settle_duration = 0.25;
};

template <typename Visit>
void for_each_member(ServiceParameters& o, const Visit& visit) {
  visit("max_steps", o.max_steps, between(1, 100000), "per request");
  visit("max_wall_time", o.max_wall_time, between(1e-3, 3600.0), "[s] per request, if it names no other");
  visit("max_state_age", o.max_state_age, between(1e-3, 3600.0), "[s] older states are answered with STALE_STATE");
  visit("max_clients_queued", o.max_clients_queued, between(0, 1000),
        "requests that may wait; more are answered with BUSY");
  visit("max_returned_points", o.max_returned_points, between(1, 1e8), "per request");
  visit("max_candidates", o.max_candidates, between(1, 10000), "per request");
  visit("max_candidate_steps", o.max_candidate_steps, between(1, 1e8), "candidates times steps per request");
  visit("max_returned_poses", o.max_returned_poses, between(1, 1e8), "of all candidates of a request");
  visit("num_particles", o.num_particles, between(1, 64),
        "worlds per candidate, where a request names no number; 1 = none");
  visit("max_particles", o.max_particles, between(1, 64), "per candidate");
  visit("max_particle_steps", o.max_particle_steps, between(1, 1e8), "candidates times particles times steps");
  visit("batch_threads", o.batch_threads, between(1, 256), "CPU threads on which candidates take their steps");
  visit("settle_linear_speed", o.settle_linear_speed, between(0.0, 100.0), "[m/s] what is slower than both ...");
  visit("settle_angular_speed", o.settle_angular_speed, between(0.0, 100.0), "[rad/s] ...");
  visit("settle_duration", o.settle_duration, between(0.0, 3600.0), "[s] ... for this long is at rest");
}

}  // namespace rigidformer_ros
