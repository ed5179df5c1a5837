// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/scene/object.hpp"
#include "rigidformer/simulation/bullet_world.hpp"

/// How a physics engine takes up bodies of which two poses and perhaps the material are known. The network's engine and
/// the engines that it is compared with share this, so that they differ in what they know of the shape alone.
namespace rigidformer {

/// Steps of a rollout as frames of a Bullet world: as many solver steps as 240 Hz frames fit, at least one. The floor
/// of the MOVi scenes stands for what is unknown of the ground.
BulletSettings observed_world(double time_step_s, double gravity, const GroundProperties& ground);

/// The later of two poses, with the mean velocity and spin between them.
BodyState mean_motion(const RigidTransform& T_ground_before, const RigidTransform& T_ground_now, double time_step_s);

/// How much faster than on average a falling body is at the end of a step [m/s], downwards negative: two poses show
/// the velocity in the middle between them.
double half_fall(double time_step_s, double gravity);

/// What a cloud of some hundred points misses of a body's lowest corner [m]: what is nearer than this touches.
constexpr double kTouching_m = 0.01;

/// True when the lowest of the body's points [N, 3] is less than 1 cm above the floor z = 0: points sampled on a
/// surface miss its lowest corner by a little.
bool touches_floor(const Points& points_body, const RigidTransform& T_ground_body);

/// The material with the means of scene/mean_material.hpp for what is unknown.
BodyProperties with_means(const BodyProperties& known, double volume_m3);

}  // namespace rigidformer
