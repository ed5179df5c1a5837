// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "rigidformer/scene/object.hpp"

namespace rigidformer::testing {

/// What makes an object impossible to predict, and a part of the reason that has to be told.
struct Defect {
  const char* name;
  const char* part;
  std::function<void(ObjectState&)> apply;
};

inline void stretch(Points& points, float x, float y, float z) {
  points.array().rowwise() *= Eigen::Array<float, 1, 3>(x, y, z);
}

/// Those of points and material: what an object can have that was observed.
inline std::vector<Defect> observable_defects() {
  return {{"line", "line", [](auto& o) { stretch(o.points_reference, 1.0F, 0.0F, 0.0F); }},
          {"one place", "one place", [](auto& o) { o.points_reference.setZero(); }},
          {"two places", "line",
           [](auto& o) {
             o.points_reference.setZero();
             o.points_reference(0, 1) = 1.0F;
           }},
          {"light", "mass_kg is 1e-09", [](auto& o) { o.properties.mass_kg = 1e-9; }},
          {"heavy", "mass_kg is 1e+08", [](auto& o) { o.properties.mass_kg = 1e8; }}};
}

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

inline std::vector<Defect> defects() {
  std::vector<Defect> all = observable_defects();
  const std::vector<Defect> others = {
      {"three points", "3 points", [](auto& o) { o.points_reference = Points(o.points_reference.topRows(3)); }},
      {"no points", "0 points", [](auto& o) { o.points_reference.resize(0, 3); }},
      {"NaN point", "not finite", [](auto& o) { o.points_reference(2, 1) = static_cast<float>(kNotANumber); }},
      {"infinite point", "not finite",
       [](auto& o) { o.points_reference(2, 1) = std::numeric_limits<float>::infinity(); }},
      {"huge", "farther", [](auto& o) { o.points_reference *= 1e25F; }},
      {"NaN pose", "T_world_current", [](auto& o) { o.T_world_current.translation.y() = kNotANumber; }},
      {"no rotation", "T_world_previous", [](auto& o) { o.T_world_previous.rotation.coeffs().setZero(); }},
      {"far away", "T_world_current is farther", [](auto& o) { o.T_world_current.translation.x() = 1e15; }},
      {"faster than numbers", "T_world_previous is farther",
       [](auto& o) { o.T_world_previous.translation.y() = 1e38; }},
      {"NaN mass", "mass_kg is nan", [](auto& o) { o.properties.mass_kg = kNotANumber; }},
      {"friction", "friction", [](auto& o) { o.properties.friction = 1e4; }},
      {"restitution", "restitution", [](auto& o) { o.properties.restitution = -0.5; }}};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

}  // namespace rigidformer::testing
