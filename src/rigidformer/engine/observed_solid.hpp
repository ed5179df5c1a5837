// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rigidformer/model/batch.hpp"
#include "rigidformer/scene/object.hpp"
#include "rigidformer/scene/shape.hpp"
#include "rigidformer/simulation/bullet_world.hpp"
#include "rigidformer/simulation/hull_distance.hpp"

namespace rigidformer {

/// An object of which no body can be made.
class BodyError : public std::invalid_argument {
 public:
  BodyError(std::int64_t object, const std::string& reason) : std::invalid_argument(reason), object_(object) {}
  std::int64_t object() const { return object_; }  ///< Index k in the batch

 private:
  std::int64_t object_;
};

/// One object of a batch as a solid body. What took time to make is shared between copies, which only read it.
struct ObservedSolid {
  std::int64_t object = 0;                      ///< Index k in the batch
  bool dynamic = true;                          ///< Else its motion is given
  std::shared_ptr<const ConvexPart> hull;       ///< Relative to the centre of mass, axes of the reference frame [m]
  std::shared_ptr<const SolidHull> distances;   ///< The same, for measuring distances
  std::shared_ptr<const CollisionShape> shape;  ///< The same, for simulating
  double volume_m3 = 0.0;
  double radius_m = 0.0;             ///< Of the hull around the centre of mass
  bool complete = false;             ///< Seen from all sides
  Eigen::Vector3d centre_reference;  ///< Centre of mass in the reference frame [m]
  BodyProperties known;              ///< Material as far as it is known
  BodyProperties properties;         ///< Complete: the means of the MOVi scenes stand for what is unknown
};

/// The same body in another role and of another material, as far as that is known.
ObservedSolid with_role(ObservedSolid solid, std::int64_t object, bool dynamic, const BodyProperties& known);

/// The same body with another hull, relative to the same centre of mass, of this volume; its material as far as known.
ObservedSolid with_hull(ObservedSolid solid, const ConvexPart& hull, double volume_m3, const BodyProperties& known);

/// The objects of scene `b` of a batch; centre_reference [B, K, 3] in double precision; all on the CPU. Throws
/// BodyError for the first one whose points span no volume.
std::vector<ObservedSolid> observe_solids(const SceneBatch& batch, const Tensor& centre_reference, std::int64_t b);

}  // namespace rigidformer
