// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/baselines/physics_engine.hpp"

#include <map>
#include <stdexcept>

#include "rigidformer/baselines/bullet_forecaster.hpp"
#include "rigidformer/baselines/convex_parts.hpp"
#include "rigidformer/baselines/mujoco_forecaster.hpp"

namespace rigidformer {

const std::vector<std::string>& physics_engine_names() {
  static const std::vector<std::string> names{"bullet", "bullet_parts", "mujoco"};
  return names;
}

std::unique_ptr<Forecaster> make_physics_engine(const std::string& name) {
#ifdef RIGIDFORMER_HAS_BULLET
  if (name == "bullet") return std::make_unique<BulletForecaster>();
#endif
#ifdef RIGIDFORMER_HAS_CONVEX_PARTS
  if (name == "bullet_parts") return std::make_unique<BulletForecaster>(name, convex_parts);
#endif
#ifdef RIGIDFORMER_HAS_MUJOCO
  if (name == "mujoco") return std::make_unique<MujocoForecaster>();
#endif
  static const std::map<std::string, std::string> packages{
      {"bullet", "libbullet-dev"},
      {"bullet_parts", "libbullet-dev, libbullet-extras-dev and libqhull-dev"},
      {"mujoco", "libbullet-dev and libmujoco-dev"}};
  const auto missing = packages.find(name);
  if (missing != packages.end()) {
    throw std::runtime_error(name + " is not built in: install " + missing->second + " and build again");
  }
  throw std::invalid_argument("no physics engine named '" + name + "'");
}

}  // namespace rigidformer
