// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "rigidformer/geometry/rigid_transform.hpp"
#include "rigidformer/io/members.hpp"

namespace rigidformer {

/// How an object takes part in a rollout.
enum class MotionMode {
  kDynamic,    ///< The network predicts the object.
  kKinematic,  ///< The object keeps the twist between its two observed states; others react to it.
  kStatic      ///< The object never moves (table, shelf, wall); others react to it.
};

inline EnumNames<MotionMode> names_of(MotionMode) {
  return {{"dynamic", MotionMode::kDynamic}, {"kinematic", MotionMode::kKinematic}, {"static", MotionMode::kStatic}};
}

/// Material parameters of one object; empty = not known to the observer.
struct BodyProperties {
  std::optional<double> mass_kg;      ///< Mass, above 0
  std::optional<double> friction;     ///< Coulomb coefficient, at least 0
  std::optional<double> restitution;  ///< Coefficient of restitution, in [0, 1]
};

/// What is known of an object when its motion is predicted.
enum class Knowledge {
  kMaterial,  ///< Its shape from all sides, friction and restitution
  kShape,     ///< Its shape from all sides
  kOneSide    ///< One side of it
};

/// Material of the ground; empty = not known to the observer. Where two surfaces touch, the product of both counts.
struct GroundProperties {
  std::optional<double> friction;     ///< Coulomb coefficient, at least 0
  std::optional<double> restitution;  ///< Coefficient of restitution, in [0, 1]
};

inline bool operator==(const GroundProperties& a, const GroundProperties& b) {
  return a.friction == b.friction && a.restitution == b.restitution;
}

/// One object as the predictor sees it: a rigid cloud and its two most recent poses, one time step apart. The reference
/// frame may be any frame fixed to the cloud; with identity poses the cloud is simply in world.
struct ObjectState {
  std::string id;
  MotionMode mode = MotionMode::kDynamic;
  Points points_reference;          ///< [N, 3] m, at least 4 points, in the reference frame
  RigidTransform T_world_previous;  ///< Pose one time step before t0
  RigidTransform T_world_current;   ///< Pose at t0
  BodyProperties properties;
  double stood_s = 0.0;  ///< For how long up to t0 it was seen not to move [s]; 0 = it moves, or that is not known
};

}  // namespace rigidformer
