// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rigidformer/engine/solid_scene.hpp"

namespace rigidformer {

/// How far above what carries it the lowest seen point of a body may be [m]: the bottom of things is cut off by
/// segmentations and hidden from cameras that look down.
double unseen_bottom_m(const ObservedSolid& solid);

/// How far each body is above what is nearest below it and may carry it [m], infinite where nothing is. Poses have
/// their origin in the centre of mass.
std::vector<double> heights_above_support(const SolidScene& scene, const std::vector<RigidTransform>& T_world_body);

/// The bodies of a scene of which some are known to stand, each as it must be for that: its hull reaches down to what
/// is below it, and so far to all sides that its centre of mass is above its foot. What was seen of it stays as it is.
/// Poses have their origin in the centre of mass; properties as far as they are known. Nothing changes without Bullet.
std::vector<ObservedSolid> on_their_feet(const SolidScene& scene, const std::vector<RigidTransform>& T_world_body,
                                         const std::vector<bool>& stands,
                                         const std::vector<BodyProperties>& properties);

}  // namespace rigidformer
