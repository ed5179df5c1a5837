// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "rigidformer/engine/observed_solid.hpp"
#include "rigidformer/model/options.hpp"
#include "rigidformer/scene/mean_material.hpp"

namespace rigidformer {

/// What an adviser takes for unknown material of an object.
struct AdviserMaterial {
  double friction, restitution;
};

/// The speed after an impact is nearly linear in the restitution, and what slides differs from what sticks: between and
/// beyond these three, weights can reach the ranges of real things (varied_scene.hpp). The first are the means of the
/// MOVi scenes, then what does not bounce, then what does not slide: on a floor of unknown friction 0.3, it has 0.75.
constexpr std::array<AdviserMaterial, kMaxAdvisers> kAdviserMaterials{
    {{kMeanFriction, kMeanRestitution}, {kMeanFriction, 0.0}, {2.5, kMeanRestitution}}};

/// The same bodies with `material` where theirs is unknown.
inline std::vector<ObservedSolid> guess_material(std::vector<ObservedSolid> solids, const AdviserMaterial& material) {
  for (ObservedSolid& solid : solids) {
    solid.properties.friction = solid.known.friction.value_or(material.friction);
    solid.properties.restitution = solid.known.restitution.value_or(material.restitution);
  }
  return solids;
}

}  // namespace rigidformer
